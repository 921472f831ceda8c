// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "protocol/dialect.h"

#include <QLatin1StringView>
#include <algorithm>

namespace protocol {

namespace {

constexpr std::array ioDx100 {
    IoRange {IoArea::UserInput, {1, 256}},
    IoRange {IoArea::UserOutput, {1001, 1256}},
    IoRange {IoArea::ExternalInput, {2001, 2256}},
    IoRange {IoArea::NetworkInput, {2501, 2756}},
    IoRange {IoArea::ExternalOutput, {3001, 3256}},
    IoRange {IoArea::NetworkOutput, {3501, 3756}},
    IoRange {IoArea::SystemInput, {4001, 4160}},
    IoRange {IoArea::SystemOutput, {5001, 5200}},
    IoRange {IoArea::PanelInput, {6001, 6064}},
    IoRange {IoArea::AuxiliaryRelay, {7001, 7999}},
    IoRange {IoArea::ControlStatus, {8001, 8064}},
    IoRange {IoArea::PseudoInput, {8201, 8220}},
};

/// FS100 and YRC1000micro differ from the YRC1000 in the external signals alone.
constexpr auto ioNewer(quint16 externalGroups)
{
    return std::array {
        IoRange {IoArea::UserInput, {1, 512}},
        IoRange {IoArea::UserOutput, {1001, 1512}},
        IoRange {IoArea::ExternalInput, {2001, quint16(2000 + externalGroups)}},
        IoRange {IoArea::NetworkInput, {2701, 2956}},
        IoRange {IoArea::ExternalOutput, {3001, quint16(3000 + externalGroups)}},
        IoRange {IoArea::NetworkOutput, {3701, 3956}},
        IoRange {IoArea::SystemInput, {4001, 4256}},
        IoRange {IoArea::SystemOutput, {5001, 5512}},
        IoRange {IoArea::PanelInput, {6001, 6064}},
        IoRange {IoArea::AuxiliaryRelay, {7001, 7999}},
        IoRange {IoArea::ControlStatus, {8001, 8512}},
        IoRange {IoArea::PseudoInput, {8701, 8720}},
    };
}
constexpr auto ioSmall = ioNewer(128);
constexpr auto ioLarge = ioNewer(512);

// The DX200's I/O ranges were not found; the YRC1000's are assumed (reference §4.1).
constexpr std::array dialects {
    Dialect {Model::DX100, "dx100", "DX100", 8, 8, 24, 16, 25, 8, 16, true, true, false, ioDx100},
    Dialect {Model::DX200, "dx200", "DX200", 8, 8, 24, 16, 25, 8, 16, true, true, false, ioLarge},
    Dialect {Model::FS100, "fs100", "FS100", 2, 2, 3, 6, 15, 1, 16, true, true, false, ioSmall},
    Dialect {Model::YRC1000, "yrc1000", "YRC1000", 8, 8, 24, 16, 25, 8, 32, true, true, true, ioLarge},
    Dialect {Model::YRC1000micro, "yrc1000micro", "YRC1000micro", 2, 2, 3, 6, 15, 1, 32, true, true, true, ioSmall},
};

} // namespace

std::optional<IoArea> Dialect::ioArea(quint32 group) const
{
    const auto found = std::ranges::find_if(io, [group](const IoRange &range) { return range.groups.contains(group); });
    return found == io.end() ? std::nullopt : std::optional {found->area};
}

InstanceRange Dialect::ioRange(IoArea area) const { return std::ranges::find(io, area, &IoRange::area)->groups; }

std::optional<Model> modelOfSoftware(QByteArrayView version)
{
    constexpr std::array<std::pair<QByteArrayView, Model>, 3> beginnings {
        {{"YAS", Model::YRC1000}, {"YBS", Model::YRC1000micro}, {"FS", Model::FS100}}};
    for (const auto &[beginning, model] : beginnings) {
        if (version.startsWith(beginning))
            return model;
    }
    return std::nullopt;
}

const Dialect &dialect(Model model) { return *std::ranges::find(dialects, model, &Dialect::model); }

const Dialect *findDialect(QStringView keyOrName)
{
    const auto found = std::ranges::find_if(dialects, [keyOrName](const Dialect &dialect) {
        return keyOrName.compare(QLatin1StringView(dialect.name), Qt::CaseInsensitive) == 0;
    });
    return found == dialects.end() ? nullptr : &*found;
}

} // namespace protocol
