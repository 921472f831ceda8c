<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Messages</name>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>Communication restored at %1. Lost %n time since connecting.</numerusform>
            <numerusform>Communication restored at %1. Lost %n times since connecting.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>%n line differs, from line %1 on.</numerusform>
            <numerusform>%n lines differ, from line %1 on.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>And %n more difference.</numerusform>
            <numerusform>And %n more differences.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>Used by %n job.</numerusform>
            <numerusform>Used by %n jobs.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>%n new entry.</numerusform>
            <numerusform>%n new entries.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>%n new alarm: %1.</numerusform>
            <numerusform>%n new alarms: %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1 is beyond the %n variable that the file announces.</numerusform>
            <numerusform>%1 is beyond the %n variables that the file announces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1, %n axis</numerusform>
            <numerusform>%1, %n axes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dialogs::ApplyDialog</name>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>Write %n value</numerusform>
            <numerusform>Write %n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>Write %n value to %1</numerusform>
            <numerusform>Write %n values to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>Stage %n value</numerusform>
            <numerusform>Stage %n values</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>%n value would change</numerusform>
            <numerusform>%n values would change</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>%n value is there already. Staging sends nothing to the controller.</numerusform>
            <numerusform>%n values are there already. Staging sends nothing to the controller.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n line cannot be read, so nothing is taken over:</numerusform>
            <numerusform>%n lines cannot be read, so nothing is taken over:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>For the remaining file too</numerusform>
            <numerusform>For the remaining %n files too</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>Back up, then restore %n file</numerusform>
            <numerusform>Back up, then restore %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>%n file is the same and not listed.</numerusform>
            <numerusform>%n files are the same and not listed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>%n file was restored and read back.</numerusform>
            <numerusform>%n files were restored and read back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>%n file was restored before that.</numerusform>
            <numerusform>%n files were restored before that.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n line moved from line %1 to line %2</numerusform>
            <numerusform>%n lines moved from line %1 to line %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>models::QueueModel</name>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>done, the controller reformatted %n line</numerusform>
            <numerusform>done, the controller reformatted %n lines</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>%n alarm active when last seen.</numerusform>
            <numerusform>%n alarms active when last seen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>%n alarm active, the newest first.</numerusform>
            <numerusform>%n alarms active, the newest first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>Reading the history from the controller: %n entry read.</numerusform>
            <numerusform>Reading the history from the controller: %n entries read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>Reading was stopped. %n entry in the journal.</numerusform>
            <numerusform>Reading was stopped. %n entries in the journal.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>The newest entry of the journal; the export has all of them.</numerusform>
            <numerusform>The newest %n entries of the journal; the export has all of them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>%n entry in the journal, kept for ever.</numerusform>
            <numerusform>%n entries in the journal, kept for ever.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>%n entry exported.</numerusform>
            <numerusform>%n entries exported.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>%n note exported.</numerusform>
            <numerusform>%n notes exported.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>Good: every byte of %n file is as it was written.</numerusform>
            <numerusform>Good: every byte of %n files is as it was written.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>The only file was backed up.</numerusform>
            <numerusform>All %n files were backed up.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>%n file differs</numerusform>
            <numerusform>%n files differ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>Not counted: %n counter, log or the like</numerusform>
            <numerusform>Not counted: %n counters, logs and the like</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>%n controller</numerusform>
            <numerusform>%n controllers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n connected</numerusform>
            <numerusform>%n connected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>%n without link</numerusform>
            <numerusform>%n without link</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>%n station that is not off</numerusform>
            <numerusform>%n stations that are not off</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>HOLD was confirmed by %n controller.</numerusform>
            <numerusform>HOLD was confirmed by %n controllers.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>%n group from %1 on is refused: %2.</numerusform>
            <numerusform>%n groups from %1 on are refused: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>%n line of IONAME.DAT could not be read.</numerusform>
            <numerusform>%n lines of IONAME.DAT could not be read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>%n job</numerusform>
            <numerusform>%n jobs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%n step, at rest.</numerusform>
            <numerusform>%n steps, at rest.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>The newest record. Scroll down for older ones.</numerusform>
            <numerusform>The newest %n records. Scroll down for older ones.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n record</numerusform>
            <numerusform>%n records</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>%n record exported.</numerusform>
            <numerusform>%n records exported.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>Send %n file</numerusform>
            <numerusform>Send %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 of %n byte</numerusform>
            <numerusform>%1 of %n bytes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>%n control group</numerusform>
            <numerusform>%n control groups</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>Delete %n file</numerusform>
            <numerusform>Delete %n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>%n sub task</numerusform>
            <numerusform>%n sub tasks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::Timeline</name>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ %n file missing</numerusform>
            <numerusform>▲ %n files missing</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>Apply %n…</numerusform>
            <numerusform>Apply %n…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>Reading %n variable…</numerusform>
            <numerusform>Reading %n variables…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>%n entry of the earlier settings cannot be read; it stays in %1.</numerusform>
            <numerusform>%n entries of the earlier settings cannot be read; they stay in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>station::Station</name>
    <message numerus="yes">
        <source>%n staged value(s) were not applied.</source>
        <translation>
            <numerusform>%n staged value was not applied.</numerusform>
            <numerusform>%n staged values were not applied.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>What may be done from here. It falls back to Monitor after %n minute without key or mouse.</numerusform>
            <numerusform>What may be done from here. It falls back to Monitor after %n minutes without key or mouse.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>Armed for %n more second. Press to disarm.</numerusform>
            <numerusform>Armed for %n more seconds. Press to disarm.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>Backup %n hour old</numerusform>
            <numerusform>Backup %n hours old</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>Backup %n day old</numerusform>
            <numerusform>Backup %n days old</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>Old backup: %n day</numerusform>
            <numerusform>Old backup: %n days</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ControllerView</name>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>The journal works again. %n record was lost.</numerusform>
            <numerusform>The journal works again. %n records were lost.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::StationList</name>
    <message numerus="yes">
        <source>%n more in Fleet</source>
        <translation>
            <numerusform>%n more in Fleet</numerusform>
            <numerusform>%n more in Fleet</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>values</name>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>… (%n more character)</numerusform>
            <numerusform>… (%n more characters)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>“%1” is too fine: %n decimal is kept.</numerusform>
            <numerusform>“%1” is too fine: %n decimals are kept.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>up to %n byte</numerusform>
            <numerusform>up to %n bytes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::DiffView</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
</TS>
