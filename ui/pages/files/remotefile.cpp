// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/pages/files/remotefile.h"

#include "protocol/codes.h"
#include "session/filesession.h"
#include "ui/widgets/question.h"

using values::FileName;
using values::Result;

namespace pages {

QString text(const Context &context, const FileName &name)
{
    return protocol::TextCodec {context.station.profile().encoding}.decode(name.bytes());
}

void readRemote(const Context &context, const FileName &name, QWidget *window,
    const std::function<void(const QByteArray &)> &handler)
{
    session::FileSession *session = context.station.controller.files();
    if (!session)
        return;
    session->save(name, window, [title = text(context, name), window, handler](const Result<QByteArray> &content) {
        if (content)
            handler(*content);
        else
            widgets::ask("fileMessage", title, protocol::explain(content.error()), {}, window);
    });
}

} // namespace pages
