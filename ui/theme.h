// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include <QColor>
#include <QFont>
#include <QPalette>
#include <QStringView>
#include <optional>
#include <span>

class QApplication;
class QWidget;

namespace ui {

/// Every colour of the window has one of these meanings; there is no other colour.
enum class Role {
    Window, ///< Behind cards; the rail.
    Strip, ///< The robot strip.
    Card, ///< Cards and tables.
    Raised, ///< Buttons, inputs, the selected tile.
    Border, ///< Edges of cards and buttons.
    Hairline, ///< Lines between rows.
    Text1, ///< Values.
    Text2, ///< Labels.
    Text3, ///< Units, "unknown" and stale values; nothing else that must be read.
    Accent, ///< Selection, focus, edit, the current line.
    AccentGround,
    Fill, ///< Filled lamps, the edge of HOLD.
    Alarm,
    AlarmGround,
    Amber, ///< Error, held, stale, not allowed.
    AmberGround,
    Magenta, ///< Simulation.
    MagentaGround,
};

enum class Scheme { Light, Dark };

struct Token {
    Role role;
    QRgb light;
    QRgb dark;
};
/// One row a role, in the order of Role.
[[nodiscard]] std::span<const Token> tokens();

[[nodiscard]] QColor color(Role role, Scheme scheme);
/// The colour for this widget, which follows the scheme of its palette.
[[nodiscard]] QColor color(Role role, const QWidget *widget);

/// The bar beside a controller's name: `tag` 1 to 3, dull colours that mean nothing but "this one".
[[nodiscard]] QColor tagColor(int tag, Scheme scheme);

/// Light or dark, by the lightness of the window colour.
[[nodiscard]] Scheme schemeOf(const QPalette &palette);
/// "light" or "dark"; nullopt for another word.
[[nodiscard]] std::optional<Scheme> schemeFromName(QStringView name);

/// Sizes are relative to the application's font.
enum class Type {
    Label, ///< Small words over values, column heads.
    Heading, ///< Card titles.
    Body,
    PageName,
    State, ///< Big words.
    StripState,
    Position,
    Hold,
    Mono, ///< Job text and hex.
};
[[nodiscard]] QFont font(Type type);

[[nodiscard]] QPalette palette(Scheme scheme);
[[nodiscard]] QString styleSheet(Scheme scheme);

/// The desktop's, as it was when the program began.
[[nodiscard]] Scheme desktopScheme();

/// Dresses the whole application. Call it once before the first window, and again for another scheme.
void apply(QApplication &application, Scheme scheme);

/// Distances in pixels.
namespace space {
constexpr int page = 16; ///< Margin of a page.
constexpr int gap = 14; ///< Between cards.
constexpr int inside = 14; ///< Inside a card.
constexpr int radius = 5;
constexpr int strip = 72;
constexpr int pageLine = 50; ///< Under the strip, on every page.
constexpr int rail = 216;
constexpr int icon = 17;
} // namespace space

} // namespace ui
