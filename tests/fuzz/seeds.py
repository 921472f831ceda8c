# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
"""seeds.py FOLDER: writes what the fuzz targets start from, a folder a target, from the golden packets and the demo."""
import fnmatch
import json
import pathlib
import re
import sys

HEADER = 32
JOB = (b"/JOB\r\n//NAME A\r\n//POS\r\n///NPOS 1,0,0,0,0,0\r\n///TOOL 0\r\n///POSTYPE PULSE\r\n///PULSE\r\n"
       b"C00000=1,-2,3,4,5,6\r\n//INST\r\n///DATE 2026/01/31 08:30\r\n///ATTR SC,RW\r\n///GROUP1 RB1\r\nNOP\r\n*L\r\n"
       b"'C\r\nMOVJ C00000 VJ=5.00\r\nJUMP *L IF IN#(1)=ON\r\nEND\r\n")
TEXTS = ["MOVE", "Gr\u00fc\u00dfe", "\u30ed\u30dc\u30c3\u30c8\uff83\uff7d\uff84", "\u673a\u5668\u4eba",
         "\u6a5f\u5668\u4eba", "\ub85c\ubd07", "\u27e88A\u27e9"]
ENCODINGS = ["latin-1", "utf-8", "shift_jis", "gbk", "big5", "euc_kr"]


def packets():
    rows = json.load(open("tests/data/golden.json"))
    for exchange in rows["exchanges"]:
        yield from exchange["packets"]
    yield from rows["malformed"] + rows["refused"]


def seeds():
    golden = [bytes.fromhex(packet["hex"]) for packet in packets()]
    files = sorted(pathlib.Path("resources/demo").iterdir())
    names = b"".join(file.name.encode() + b"\r\n" for file in files)
    jobs = [JOB] + [file.read_bytes() for file in files if file.suffix == ".JBI"]
    contents = {packet[HEADER:] for packet in golden}
    yield "packet", golden
    yield "payload", [bytes([row, row >> 1, row % 9, 1, 0, row]) + rest for row, rest in enumerate(sorted(contents))]
    yield "fileBlocks", [bytes([0, 0]) + names, bytes([1, 0, 1, 2]) + b"AB" + bytes([1, 2, 1]) + b"C"]
    yield "fileList", [names, b"A.JBI\r\n\r\nB\\C.JBI\r\n.JBI"]
    yield "text", [bytes([number, direction, 5]) + text.encode("utf-8" if direction == 2 else encoding, "ignore")
                   for number, encoding in enumerate(ENCODINGS) for direction in range(3) for text in TEXTS]
    yield "inform", [start + job for start in (b"\0", b"\1A.JBI\n", b"\1A.CND\n", b"\2") for job in jobs] + [
        b"\3" + b"a" * 64 + b"  data/A.JBI\n"]


def cell_files():
    """One byte for the type by the registry's order, one for the encoding, one for what is done."""
    registry = pathlib.Path("core/cellfiles/filetypes.cpp").read_text()
    patterns = re.findall(r'FileType\s*\{\s*"([^"]+)"', registry)
    for file in sorted(pathlib.Path("tests/data/cell").rglob("*.*")):
        fits = [row for row, pattern in enumerate(patterns) if fnmatch.fnmatch(file.name.upper(), pattern)]
        for row in fits[:1]:
            yield from (bytes([row, encoding, done]) + file.read_bytes()[:897] for encoding in (0, 2) for done in (0, 1))


for target, contents in [*seeds(), ("cellFile", cell_files())]:
    folder = pathlib.Path(sys.argv[1], target)
    folder.mkdir(parents=True, exist_ok=True)
    for number, content in enumerate(contents):
        (folder / f"{number:04}").write_bytes(content)
