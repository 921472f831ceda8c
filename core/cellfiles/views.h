// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "cellfiles/view.h"

/// What each type of file says, as tables. filetypes.cpp names them.
namespace cellfiles {

using Codec = protocol::TextCodec;

// Of the typed grammars.
[[nodiscard]] View toolView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View userFrameView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View cubeView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View variableView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View variableNameView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View signalNameView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View registerNameView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View timerNameView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View ladderView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View pseudoInputView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View encoderOffsetView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View homePositionView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View parameterView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View systemView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View panelBoxView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View logView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View alarmView(QByteArrayView file, const Codec &codec);

// Of lines under headers, with names for the fields that are known (blockviews.cpp).
[[nodiscard]] View blockView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View jobView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View weavingView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View shockView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View arcView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View welderView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View shapeView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View signalGroupView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View speedLimitView(QByteArrayView file, const Codec &codec);
[[nodiscard]] View stopReasonView(QByteArrayView file, const Codec &codec);
/// Rows with an address are secret.
[[nodiscard]] View addressView(QByteArrayView file, const Codec &codec);
/// Rows of the sections that hold addresses, users and passwords are secret.
[[nodiscard]] View networkView(QByteArrayView file, const Codec &codec);
/// Every row is secret.
[[nodiscard]] View secretView(QByteArrayView file, const Codec &codec);

} // namespace cellfiles
