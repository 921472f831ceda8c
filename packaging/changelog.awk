# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
# Writes CHANGELOG.md as AppStream releases (-v form=appstream) or as a Debian changelog (-v form=debian).
# -v day=2026-01-31 is the date of a version that is not released yet.
function debian_item(text,    words, count, line, i) {
    count = split(text, words, " ")
    line = "  *"
    for (i = 1; i <= count; ++i) {
        if (length(line " " words[i]) > 78) { print line; line = "   " }
        line = line " " words[i]
    }
    print line
}
function appstream_item(text) {
    gsub(/&/, "\\&amp;", text); gsub(/</, "\\&lt;", text); gsub(/>/, "\\&gt;", text)
    print "          <li>" text "</li>"
}
function end_item() {
    if (item == "") return
    gsub(/`/, "", item)
    if (form == "debian") debian_item(item)
    else appstream_item(item)
    item = ""
}
function end_version(    command, stamp) {
    end_item()
    if (version == "") return
    command = "LC_ALL=C date -u -R -d " date
    if (form != "debian") { print "        </ul>\n      </description>\n    </release>"; return }
    command | getline stamp
    print "\n -- The Pendesk authors <pendesk@pendesk.invalid>  " stamp "\n"
}
function begin_version() {
    released = date ~ /^[0-9]/
    if (!released) date = day
    if (form == "debian") print "pendesk (" version ") " (released ? "unstable" : "UNRELEASED") "; urgency=medium\n"
    else print "    <release version=\"" version "\" date=\"" date "\" type=\"" \
        (released ? "stable" : "development") "\">\n      <description>\n        <ul>"
}
/^## / {
    end_version()
    version = $2
    date = $0
    gsub(/.*\(|\)/, "", date)
    begin_version()
}
/^- / { end_item(); item = substr($0, 3) }
/^  / && item != "" { item = item " " substr($0, 3) }
END { end_version() }
