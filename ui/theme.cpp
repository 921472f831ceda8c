// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/theme.h"

#include "ui/plainstyle.h"
#include <QApplication>
#include <QFontDatabase>
#include <QToolTip>
#include <QWidget>

namespace ui {

namespace {

constexpr Token tokenTable[] {
    {Role::Window, 0xFFE6E8EA, 0xFF1B2024},
    {Role::Strip, 0xFFD9DDE0, 0xFF15191C},
    {Role::Card, 0xFFF5F6F7, 0xFF23292E},
    {Role::Raised, 0xFFFFFFFF, 0xFF2B3238},
    {Role::Border, 0xFFC8CDD2, 0xFF3C464E},
    {Role::Hairline, 0xFFDDE1E4, 0xFF313A41},
    {Role::Text1, 0xFF1A2026, 0xFFE6EAED},
    {Role::Text2, 0xFF56606A, 0xFFA7B1B9},
    {Role::Text3, 0xFF87919A, 0xFF78838C},
    {Role::Accent, 0xFF2B5C8C, 0xFF86B6E2},
    {Role::AccentGround, 0xFFDCE6F0, 0xFF26384A},
    {Role::Fill, 0xFF2A333B, 0xFFD5DBE0},
    {Role::Alarm, 0xFFB71C1C, 0xFFFF8A84},
    {Role::AlarmGround, 0xFFF9E0DF, 0xFF4A2426},
    {Role::Amber, 0xFF8A5300, 0xFFF5BC62},
    {Role::AmberGround, 0xFFFBEBCF, 0xFF453517},
    {Role::Magenta, 0xFF96206F, 0xFFEE93D0},
    {Role::MagentaGround, 0xFFF6DFF0, 0xFF44233A},
};

constexpr bool isInOrder()
{
    for (std::size_t i = 0; i < std::size(tokenTable); ++i) {
        if (tokenTable[i].role != Role(i))
            return false;
    }
    return true;
}
static_assert(isInOrder() && std::size(tokenTable) == std::size_t(Role::MagentaGround) + 1);

struct TypeRow {
    qreal scale;
    QFont::Weight weight;
};

constexpr TypeRow typeRow(Type type)
{
    switch (type) {
    case Type::Label: return {0.85, QFont::Normal};
    case Type::Heading: return {0.9, QFont::DemiBold};
    case Type::PageName: return {1.25, QFont::DemiBold};
    case Type::State: return {1.4, QFont::DemiBold};
    case Type::StripState: return {1.3, QFont::DemiBold};
    case Type::Position: return {1.45, QFont::DemiBold};
    case Type::Hold: return {1.55, QFont::Bold};
    case Type::Body:
    case Type::Mono: break;
    }
    return {1.0, QFont::Normal};
}

void scale(QFont &font, qreal factor)
{
    if (font.pointSizeF() > 0)
        font.setPointSizeF(font.pointSizeF() * factor);
    else
        font.setPixelSize(qRound(font.pixelSize() * factor));
}

/// Inter first; where it is missing, Qt falls back to the desktop's own font by itself.
QFont applicationFont(const QFont &desktop)
{
    QFont font = desktop;
    QStringList families {QStringLiteral("Inter")};
    for (const QString &family : desktop.families()) {
        if (!families.contains(family))
            families << family;
    }
    font.setFamilies(families);
#if QT_VERSION >= QT_VERSION_CHECK(6, 7, 0)
    font.setFeature("tnum", 1);
#endif
    return font;
}

/// The colours that words may have; see widgets::setTextRole().
QString textRoles(Scheme scheme)
{
    QString sheet;
    for (const Role role :
        {Role::Text1, Role::Text2, Role::Text3, Role::Accent, Role::Alarm, Role::Amber, Role::Magenta})
        sheet += QStringLiteral("*[textRole=\"%1\"] { color: %2; }\n").arg(int(role)).arg(color(role, scheme).name());
    return sheet;
}

/// What stands on a ground of the accent colour.
Role onAccent(Scheme scheme) { return scheme == Scheme::Light ? Role::Raised : Role::Window; }

} // namespace

std::span<const Token> tokens() { return tokenTable; }

QColor color(Role role, Scheme scheme)
{
    const Token &token = tokenTable[std::size_t(role)];
    return QColor::fromRgb(scheme == Scheme::Light ? token.light : token.dark);
}

QColor color(Role role, const QWidget *widget) { return color(role, schemeOf(widget->palette())); }

QColor tagColor(int tag, Scheme scheme)
{
    constexpr QRgb slate = 0xFF66798C;
    constexpr QRgb sage = 0xFF75896F;
    constexpr QRgb sand = 0xFF8E7F68;
    const QColor quiet {tag == 1 ? slate : tag == 2 ? sage : sand};
    return scheme == Scheme::Light ? quiet : quiet.lighter(115);
}

Scheme schemeOf(const QPalette &palette)
{
    return palette.color(QPalette::Window).lightness() < 128 ? Scheme::Dark : Scheme::Light;
}

std::optional<Scheme> schemeFromName(QStringView name)
{
    if (name == u"light")
        return Scheme::Light;
    if (name == u"dark")
        return Scheme::Dark;
    return std::nullopt;
}

QFont font(Type type)
{
    QFont font = type == Type::Mono ? QFontDatabase::systemFont(QFontDatabase::FixedFont) : QApplication::font();
    if (type == Type::Mono)
        return font;
    const TypeRow row = typeRow(type);
    scale(font, row.scale);
    font.setWeight(row.weight);
    return font;
}

QPalette palette(Scheme scheme)
{
    struct Row {
        QPalette::ColorRole paletteRole;
        Role role;
    };
    const Row rows[] {
        {QPalette::Window, Role::Window},
        {QPalette::WindowText, Role::Text1},
        {QPalette::Base, Role::Raised},
        {QPalette::AlternateBase, Role::Card},
        {QPalette::Text, Role::Text1},
        {QPalette::PlaceholderText, Role::Text3},
        {QPalette::Button, Role::Raised},
        {QPalette::ButtonText, Role::Text1},
        {QPalette::BrightText, Role::Alarm},
        {QPalette::Light, Role::Raised},
        {QPalette::Midlight, Role::Hairline},
        {QPalette::Mid, Role::Border},
        {QPalette::Dark, Role::Border},
        {QPalette::Shadow, Role::Border},
        {QPalette::Highlight, Role::Accent},
        {QPalette::HighlightedText, onAccent(scheme)},
        {QPalette::Link, Role::Accent},
        {QPalette::LinkVisited, Role::Accent},
        {QPalette::ToolTipBase, Role::Raised},
        {QPalette::ToolTipText, Role::Text1},
    };
    QPalette result;
    for (const Row &row : rows)
        result.setColor(row.paletteRole, color(row.role, scheme));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        result.setColor(QPalette::Disabled, role, color(Role::Text3, scheme));
    return result;
}

QString styleSheet(Scheme scheme)
{
    const auto name = [scheme](Role role) { return color(role, scheme).name(); };
    return QStringLiteral(R"(
QPushButton { background: %1; border: 1px solid %2; border-radius: 4px; padding: 5px 14px; }
QPushButton:hover { border-color: %3; }
QPushButton:focus { border-color: %4; }
QPushButton:pressed { background: %5; }
QPushButton:disabled { color: %6; }
QPushButton[primary="true"] { background: %4; border-color: %4; color: %7; font-weight: 600; }
QPushButton[primary="true"]:focus { border: 2px solid %8; padding: 4px 13px; }
QPushButton[primary="true"]:disabled { background: %2; border-color: %2; color: %3; }
QPushButton[link="true"] { background: transparent; border: 1px solid transparent; padding: 2px 6px; font-weight: 600; }
QPushButton[link="true"]:hover, QPushButton[link="true"]:focus { border-color: %8; }
QPushButton[segment="true"] { border-radius: 0; padding: 5px 8px; }
QPushButton[segment="true"]:checked { background: %5; color: %4; font-weight: 600; border-color: %4; }
QPushButton[jog="true"] { padding: 5px 4px; }
QPushButton[rail="true"] { background: transparent; border: 1px solid transparent; border-radius: 5px; padding: 5px 8px;
    text-align: left; }
QPushButton[rail="true"]:hover, QPushButton[rail="true"]:focus { border-color: %2; }
QPushButton[rail="true"]:checked { background: %5; color: %4; font-weight: 600; }
QPushButton[rail="true"]::menu-indicator { width: 0; }
QPushButton[badge="true"] { background: transparent; border: 1px solid %3; border-radius: 8px; padding: 1px 8px;
    color: %3; }
QPushButton[badge="true"]:hover, QPushButton[badge="true"]:focus { border-color: %4; color: %8; }
QPushButton[badge="true"]::menu-indicator { width: 0; }
QPushButton[amber="true"] { background: %10; border-color: %11; color: %11; }
QToolTip { background: %1; color: %8; border: 1px solid %2; padding: 3px; }
QStatusBar { background: %9; border-top: 1px solid %2; }
QStatusBar::item { border: none; }
QTabBar::tab { background: transparent; border: none; border-bottom: 2px solid transparent; padding: 6px 10px; }
QTabBar::tab:hover { color: %4; }
QTabBar::tab:selected { color: %4; border-bottom-color: %4; }
QTabBar::tab:focus { background: %5; }
QAbstractItemView { border: 1px solid transparent; }
QAbstractItemView:focus { border-color: %4; }
QScrollArea[reads="true"] { border: 1px solid transparent; }
QScrollArea[reads="true"]:focus { border-color: %4; }
QTableView QTableCornerButton::section { background: transparent; border: none; }
)")
               .arg(name(Role::Raised), name(Role::Border), name(Role::Text2), name(Role::Accent),
                   name(Role::AccentGround), name(Role::Text3), name(onAccent(scheme)), name(Role::Text1),
                   name(Role::Window), name(Role::AmberGround), name(Role::Amber))
        + textRoles(scheme);
}

Scheme desktopScheme()
{
    static const Scheme scheme = schemeOf(QApplication::palette()); // ours comes later
    return scheme;
}

void apply(QApplication &application, Scheme scheme)
{
    (void)desktopScheme();
    static const QFont desktopFont = QApplication::font();
    application.setStyle(new PlainStyle);
    QApplication::setFont(applicationFont(desktopFont));
    QApplication::setPalette(palette(scheme));
    application.setStyleSheet(styleSheet(scheme));
}

} // namespace ui
