// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "robot/joblibrary.h"
#include "support/cell.h"

using robot::JobLibrary;
using values::ErrorKind;
using values::FileName;
using values::Status;
using virtualcontroller::Faults;

namespace {

FileName job(const char *name) { return *FileName::create(name); }

} // namespace

class TestJobLibrary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsTheList()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobLibrary library {*cell.orders};
        QVERIFY(!library.list().value);
        library.readList();
        QVERIFY(library.isListing());
        library.readList(); // under way already
        QTRY_VERIFY(library.list().value);
        QVERIFY(!library.isListing());
        QVERIFY(library.list().value->contains(job("WELD_A12.JBI")));
        QVERIFY(std::ranges::is_sorted(*library.list().value));
        QCOMPARE(cell.server->asked(protocol::Service::ListFiles), 2); // the request and its acknowledgement
    }

    void readsAJob()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobLibrary library {*cell.orders};
        library.readText(job("HOME.JBI"));
        QVERIFY(library.copy(job("HOME.JBI")).isReading);
        QTRY_VERIFY(library.copy(job("HOME.JBI")).text.value);
        QCOMPARE(*library.copy(job("HOME.JBI")).text.value, cell.server->memory().files.at("HOME.JBI"));
        QVERIFY(!library.copy(job("HOME.JBI")).mayBeOld);
    }

    void aJobThatIsGoneSaysSo()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobLibrary library {*cell.orders};
        library.readText(job("GONE.JBI"));
        QTRY_VERIFY(library.copy(job("GONE.JBI")).trouble);
        QVERIFY(library.copy(job("GONE.JBI")).trouble->kind == ErrorKind::Refused);
        QVERIFY(!library.copy(job("GONE.JBI")).text.value);
    }

    void aFailedReadKeepsTheCopy()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobLibrary library {*cell.orders};
        library.readText(job("HOME.JBI"));
        QTRY_VERIFY(library.copy(job("HOME.JBI")).text.value);
        cell.server->memory().files.erase("HOME.JBI");
        library.readText(job("HOME.JBI"));
        QTRY_VERIFY(library.copy(job("HOME.JBI")).trouble);
        QVERIFY(library.copy(job("HOME.JBI")).text.value);
    }

    void teachMakesACopyOld()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobLibrary library {*cell.orders};
        library.readText(job("HOME.JBI"));
        QTRY_VERIFY(library.copy(job("HOME.JBI")).text.value);
        cell.server->memory().status.data1.setFlag(Status::Teach);
        QTRY_VERIFY(library.copy(job("HOME.JBI")).mayBeOld);
        cell.server->memory().status.data1.setFlag(Status::Teach, false);
        QTRY_VERIFY(!cell.orders->situation().status->isTeach());
        QVERIFY(library.copy(job("HOME.JBI")).mayBeOld);
        library.readText(job("HOME.JBI"));
        QTRY_VERIFY(!library.copy(job("HOME.JBI")).mayBeOld);
    }

    void aLostLinkMakesEverythingOld()
    {
        Cell cell;
        QVERIFY(cell.live());
        JobLibrary library {*cell.orders};
        library.readList();
        library.readText(job("HOME.JBI"));
        QTRY_VERIFY(library.list().value && library.copy(job("HOME.JBI")).text.value);
        cell.server->setFaults(Faults {{{.command = 0}}});
        library.readList();
        library.readText(job("HOME.JBI"));
        cell.controller->close();
        QVERIFY(!library.isListing()); // nothing waits for ever
        QVERIFY(!library.copy(job("HOME.JBI")).isReading);
        QVERIFY(library.isListOld());
        QVERIFY(library.copy(job("HOME.JBI")).mayBeOld);
        library.readList(); // without a link
        QVERIFY(library.listTrouble()->kind == ErrorKind::NotSent);
    }

    void aSilentFilePortIsSaid()
    {
        Cell cell;
        QVERIFY(cell.live());
        cell.server->setFaults(Faults {{{.command = 0}}});
        JobLibrary library {*cell.orders};
        library.readList();
        QTRY_VERIFY(library.listTrouble());
        QVERIFY(library.listTrouble()->kind == ErrorKind::NoAnswer);
        QVERIFY(!library.list().value);
    }
};

QTEST_GUILESS_MAIN(TestJobLibrary)
#include "tst_joblibrary.moc"
