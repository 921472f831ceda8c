// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/models/recordmodel.h"

namespace models {

void RecordModelBase::setLoading(bool loading, const QString &trouble)
{
    m_isLoading = loading;
    m_trouble = trouble;
    Q_EMIT loadingChanged();
}

} // namespace models
