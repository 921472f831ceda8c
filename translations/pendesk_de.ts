<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (Software)</translation>
    </message>
    <message>
        <source>Access level…</source>
        <translation>Zugriffsstufe…</translation>
    </message>
    <message>
        <source>Open this page in its own window</source>
        <translation>Diese Seite in eigenem Fenster öffnen</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Verbinden…</translation>
    </message>
    <message>
        <source>Connect to this controller</source>
        <translation>Mit dieser Steuerung verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Verbindung trennen</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Diagnose…</source>
        <translation>Diagnose…</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>Diagnose kopieren</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Über Pendesk</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Language and look…</source>
        <translation>Sprache und Aussehen…</translation>
    </message>
    <message>
        <source>Readiness…</source>
        <translation>Bereitschaft…</translation>
    </message>
    <message>
        <source>Help and shortcuts</source>
        <translation>Hilfe und Tastenkürzel</translation>
    </message>
</context>
<context>
    <name>Alarms</name>
    <message>
        <source>Major</source>
        <translation>Schwer</translation>
    </message>
    <message>
        <source>Minor</source>
        <translation>Leicht</translation>
    </message>
    <message>
        <source>User, system</source>
        <translation>Benutzer, System</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Off-line</source>
        <translation>Offline</translation>
    </message>
    <message>
        <source>◆ unacknowledged</source>
        <translation>◆ unquittiert</translation>
    </message>
    <message>
        <source>■ acknowledged</source>
        <translation>■ quittiert</translation>
    </message>
    <message>
        <source>▲ cleared, unacknowledged</source>
        <translation>▲ behoben, unquittiert</translation>
    </message>
    <message>
        <source>□ cleared</source>
        <translation>□ behoben</translation>
    </message>
    <message>
        <source>No sub code.</source>
        <translation>Kein Untercode.</translation>
    </message>
    <message>
        <source>%1: %2. As sent: %3, type %4.</source>
        <translation>%1: %2. Wie gesendet: %3, Typ %4.</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1: %2.</source>
        <comment>what is wrong: what helps</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>nicht erfüllt</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>cannot be read over HSES</source>
        <translation>über HSES nicht lesbar</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what was tried: how it ended</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Reset alarm</source>
        <translation>Alarm zurücksetzen</translation>
    </message>
    <message>
        <source>Cancel error</source>
        <translation>Fehler löschen</translation>
    </message>
    <message>
        <source>Write a signal</source>
        <translation>Ein Signal schreiben</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>Ein Register schreiben</translation>
    </message>
    <message>
        <source>Write a variable</source>
        <translation>Eine Variable schreiben</translation>
    </message>
    <message>
        <source>Select a job</source>
        <translation>Einen Job wählen</translation>
    </message>
    <message>
        <source>Select a master job</source>
        <translation>Einen Masterjob wählen</translation>
    </message>
    <message>
        <source>Start the job</source>
        <translation>Den Job starten</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (Software)</translation>
    </message>
    <message>
        <source>Release HOLD</source>
        <translation>HOLD aufheben</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ein</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>Servo aus</translation>
    </message>
    <message>
        <source>HLOCK on</source>
        <translation>HLOCK ein</translation>
    </message>
    <message>
        <source>HLOCK off</source>
        <translation>HLOCK aus</translation>
    </message>
    <message>
        <source>Select the cycle mode</source>
        <translation>Zyklusart wählen</translation>
    </message>
    <message>
        <source>Show a message on the pendant</source>
        <translation>Meldung auf dem Programmierhandgerät zeigen</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Tippbetrieb</translation>
    </message>
    <message>
        <source>Send a file to the controller</source>
        <translation>Eine Datei an die Steuerung senden</translation>
    </message>
    <message>
        <source>Get a file from the controller</source>
        <translation>Eine Datei von der Steuerung holen</translation>
    </message>
    <message>
        <source>Delete a file on the controller</source>
        <translation>Eine Datei auf der Steuerung löschen</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Eine Sicherung zurückspielen</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Bedienen</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>disarmed by hand</source>
        <translation>von Hand unscharf geschaltet</translation>
    </message>
    <message>
        <source>nobody used key or mouse for a minute</source>
        <translation>eine Minute lang wurden weder Tastatur noch Maus benutzt</translation>
    </message>
    <message>
        <source>another program came to the front</source>
        <translation>ein anderes Programm kam in den Vordergrund</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>der Bildschirm wurde gesperrt</translation>
    </message>
    <message>
        <source>communication was lost</source>
        <translation>die Kommunikation ging verloren</translation>
    </message>
    <message>
        <source>the mode changed at the controller</source>
        <translation>die Betriebsart wurde an der Steuerung gewechselt</translation>
    </message>
    <message>
        <source>an alarm came up</source>
        <translation>ein Alarm ist aufgetreten</translation>
    </message>
    <message>
        <source>the access level fell back</source>
        <translation>die Zugriffsstufe fiel zurück</translation>
    </message>
    <message>
        <source>another window came to the front</source>
        <translation>ein anderes Fenster kam in den Vordergrund</translation>
    </message>
    <message>
        <source>another controller was armed</source>
        <translation>eine andere Steuerung wurde scharf geschaltet</translation>
    </message>
    <message>
        <source>The link to the controller is up</source>
        <translation>Die Verbindung zur Steuerung steht</translation>
    </message>
    <message>
        <source>The access level is Operate or Engineer</source>
        <translation>Die Zugriffsstufe ist Bedienen oder Einrichten</translation>
    </message>
    <message>
        <source>The access level is Engineer</source>
        <translation>Die Zugriffsstufe ist Einrichten</translation>
    </message>
    <message>
        <source>The status is fresh</source>
        <translation>Der Status ist aktuell</translation>
    </message>
    <message>
        <source>This controller is armed</source>
        <translation>Diese Steuerung ist scharf</translation>
    </message>
    <message>
        <source>REMOTE is on</source>
        <translation>REMOTE ist eingeschaltet</translation>
    </message>
    <message>
        <source>The mode is PLAY</source>
        <translation>Die Betriebsart ist PLAY</translation>
    </message>
    <message>
        <source>The mode is not TEACH</source>
        <translation>Die Betriebsart ist nicht TEACH</translation>
    </message>
    <message>
        <source>There is no alarm</source>
        <translation>Es liegt kein Alarm an</translation>
    </message>
    <message>
        <source>There is no error</source>
        <translation>Es liegt kein Fehler an</translation>
    </message>
    <message>
        <source>Not held by the pendant</source>
        <translation>Nicht vom Programmierhandgerät gehalten</translation>
    </message>
    <message>
        <source>Not held by an external signal</source>
        <translation>Nicht von einem externen Signal gehalten</translation>
    </message>
    <message>
        <source>Not held by a command</source>
        <translation>Nicht von einem Befehl gehalten</translation>
    </message>
    <message>
        <source>Held by a command</source>
        <translation>Von einem Befehl gehalten</translation>
    </message>
    <message>
        <source>Servo power is on</source>
        <translation>Servo ist eingeschaltet</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>Es läuft kein Job</translation>
    </message>
    <message>
        <source>A job is selected</source>
        <translation>Ein Job ist gewählt</translation>
    </message>
    <message>
        <source>The numbering of variables is verified</source>
        <translation>Die Nummerierung der Variablen ist geprüft</translation>
    </message>
    <message>
        <source>The model takes move orders</source>
        <translation>Das Modell nimmt Bewegungsbefehle an</translation>
    </message>
    <message>
        <source>The safety circuit is closed</source>
        <translation>Der Sicherheitskreis ist geschlossen</translation>
    </message>
    <message>
        <source>Not held by a playback panel</source>
        <translation>Nicht von einem Playback-Bedienfeld gehalten</translation>
    </message>
    <message>
        <source>Home position and position check are confirmed</source>
        <translation>Home-Position und Positionsprüfung sind bestätigt</translation>
    </message>
    <message>
        <source>Starting is not locked at the panel</source>
        <translation>Der Start ist am Bedienfeld nicht gesperrt</translation>
    </message>
    <message>
        <source>Mode and cycle are not locked at the panel</source>
        <translation>Betriebsart und Zyklus sind am Bedienfeld nicht gesperrt</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is permitted</source>
        <translation>Das Wählen eines Jobs in REMOTE und PLAY ist zugelassen</translation>
    </message>
    <message>
        <source>Changing the master job is permitted</source>
        <translation>Das Ändern des Masterjobs ist zugelassen</translation>
    </message>
    <message>
        <source>The job exists on the controller</source>
        <translation>Der Job ist auf der Steuerung vorhanden</translation>
    </message>
    <message>
        <source>Nothing is being edited at the pendant</source>
        <translation>Am Programmierhandgerät wird nichts bearbeitet</translation>
    </message>
    <message>
        <source>No other function uses the files</source>
        <translation>Keine andere Funktion benutzt die Dateien</translation>
    </message>
    <message>
        <source>The data are not protected</source>
        <translation>Die Daten sind nicht geschützt</translation>
    </message>
    <message>
        <source>Replacing existing files is permitted</source>
        <translation>Das Ersetzen vorhandener Dateien ist zugelassen</translation>
    </message>
    <message>
        <source>There is no link to the controller</source>
        <translation>Es besteht keine Verbindung zur Steuerung</translation>
    </message>
    <message>
        <source>connect, or wait until it answers again</source>
        <translation>verbinden oder warten, bis sie wieder antwortet</translation>
    </message>
    <message>
        <source>The access level is Monitor</source>
        <translation>Die Zugriffsstufe ist Beobachten</translation>
    </message>
    <message>
        <source>switch to Operate in the strip (Ctrl+L)</source>
        <translation>in der Leiste auf Bedienen umschalten (Strg+L)</translation>
    </message>
    <message>
        <source>The access level is not Engineer</source>
        <translation>Die Zugriffsstufe ist nicht Einrichten</translation>
    </message>
    <message>
        <source>switch to Engineer in the strip (Ctrl+L)</source>
        <translation>in der Leiste auf Einrichten umschalten (Strg+L)</translation>
    </message>
    <message>
        <source>The status was not read just now</source>
        <translation>Der Status ist nicht aktuell</translation>
    </message>
    <message>
        <source>wait a moment; if it stays so, look at the link</source>
        <translation>einen Moment warten; bleibt es so, die Verbindung prüfen</translation>
    </message>
    <message>
        <source>This controller is not armed</source>
        <translation>Diese Steuerung ist nicht scharf</translation>
    </message>
    <message>
        <source>arm it on this page</source>
        <translation>auf dieser Seite scharf schalten</translation>
    </message>
    <message>
        <source>REMOTE is off</source>
        <translation>REMOTE ist ausgeschaltet</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1</source>
        <translation>den Schlüsselschalter des Programmierhandgeräts auf REMOTE drehen und CMD REMOTE SEL einschalten: %1</translation>
    </message>
    <message>
        <source>The mode is not PLAY</source>
        <translation>Die Betriebsart ist nicht PLAY</translation>
    </message>
    <message>
        <source>turn the pendant key to PLAY or REMOTE</source>
        <translation>den Schlüsselschalter des Programmierhandgeräts auf PLAY oder REMOTE drehen</translation>
    </message>
    <message>
        <source>The controller is in TEACH</source>
        <translation>Die Steuerung ist in TEACH</translation>
    </message>
    <message>
        <source>the person at the pendant has the robot: turn the key to REMOTE when that is over</source>
        <translation>die Person am Programmierhandgerät hat den Roboter: den Schlüsselschalter erst auf REMOTE drehen, wenn das beendet ist</translation>
    </message>
    <message>
        <source>There is an alarm</source>
        <translation>Es liegt ein Alarm an</translation>
    </message>
    <message>
        <source>remove its cause, then reset it on the Alarms page</source>
        <translation>die Ursache beseitigen, dann den Alarm auf der Seite Alarme zurücksetzen</translation>
    </message>
    <message>
        <source>There is an error</source>
        <translation>Es liegt ein Fehler an</translation>
    </message>
    <message>
        <source>read it on the Alarms page, then cancel it</source>
        <translation>den Fehler auf der Seite Alarme lesen, dann löschen</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>Vom Programmierhandgerät gehalten</translation>
    </message>
    <message>
        <source>release it there</source>
        <translation>dort aufheben</translation>
    </message>
    <message>
        <source>Held by an external signal</source>
        <translation>Von einem externen Signal gehalten</translation>
    </message>
    <message>
        <source>release it where that signal comes from</source>
        <translation>dort aufheben, wo dieses Signal herkommt</translation>
    </message>
    <message>
        <source>release HOLD on the Jobs page</source>
        <translation>HOLD auf der Seite Jobs aufheben</translation>
    </message>
    <message>
        <source>No command holds the robot</source>
        <translation>Kein Befehl hält den Roboter</translation>
    </message>
    <message>
        <source>there is nothing to release from here</source>
        <translation>von hier aus ist nichts aufzuheben</translation>
    </message>
    <message>
        <source>Servo power is off</source>
        <translation>Servo ist ausgeschaltet</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>Servo einschalten</translation>
    </message>
    <message>
        <source>A job is running</source>
        <translation>Ein Job läuft</translation>
    </message>
    <message>
        <source>wait until it has ended, or hold it</source>
        <translation>warten, bis er beendet ist, oder ihn mit HOLD anhalten</translation>
    </message>
    <message>
        <source>No job is selected</source>
        <translation>Es ist kein Job gewählt</translation>
    </message>
    <message>
        <source>select one on the Jobs page</source>
        <translation>auf der Seite Jobs einen wählen</translation>
    </message>
    <message>
        <source>The numbering of variables is not verified</source>
        <translation>Die Nummerierung der Variablen ist nicht geprüft</translation>
    </message>
    <message>
        <source>compare two variables with the pendant (Variables page)</source>
        <translation>zwei Variablen mit dem Programmierhandgerät vergleichen (Seite Variablen)</translation>
    </message>
    <message>
        <source>This model takes no move orders</source>
        <translation>Dieses Modell nimmt keine Bewegungsbefehle an</translation>
    </message>
    <message>
        <source>move it with the pendant</source>
        <translation>mit dem Programmierhandgerät bewegen</translation>
    </message>
    <message>
        <source>The safety circuit is open</source>
        <translation>Der Sicherheitskreis ist offen</translation>
    </message>
    <message>
        <source>look at emergency stops, doors and the enabling switch</source>
        <translation>Not-Halt-Taster, Türen und Zustimmungsschalter prüfen</translation>
    </message>
    <message>
        <source>Held by a playback panel</source>
        <translation>Von einem Playback-Bedienfeld gehalten</translation>
    </message>
    <message>
        <source>Home position or position check is missing</source>
        <translation>Home-Position oder Positionsprüfung fehlt</translation>
    </message>
    <message>
        <source>confirm the position at the pendant</source>
        <translation>die Position am Programmierhandgerät bestätigen</translation>
    </message>
    <message>
        <source>Starting is locked at the panel</source>
        <translation>Der Start ist am Bedienfeld gesperrt</translation>
    </message>
    <message>
        <source>release the start lock (I/O or panel prohibit) at the cell</source>
        <translation>die Startsperre (E/A oder Verbot am Bedienfeld) an der Zelle aufheben</translation>
    </message>
    <message>
        <source>Mode and cycle are locked at the panel</source>
        <translation>Betriebsart und Zyklus sind am Bedienfeld gesperrt</translation>
    </message>
    <message>
        <source>release the panel lock (I/O or panel prohibit) at the cell</source>
        <translation>die Bedienfeldsperre (E/A oder Verbot am Bedienfeld) an der Zelle aufheben</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is prohibited</source>
        <translation>Das Wählen eines Jobs in REMOTE und PLAY ist verboten</translation>
    </message>
    <message>
        <source>set “job select when remote and play” to permit: %1</source>
        <translation>„job select when remote and play“ auf „permit“ stellen: %1</translation>
    </message>
    <message>
        <source>Changing the master job is prohibited</source>
        <translation>Das Ändern des Masterjobs ist verboten</translation>
    </message>
    <message>
        <source>permit it at the pendant (master call, teach lock): %1</source>
        <translation>am Programmierhandgerät zulassen (Masteraufruf, Teach-Sperre): %1</translation>
    </message>
    <message>
        <source>The job is not on the controller</source>
        <translation>Der Job ist nicht auf der Steuerung</translation>
    </message>
    <message>
        <source>read the list of jobs again</source>
        <translation>die Jobliste neu lesen</translation>
    </message>
    <message>
        <source>Something is being edited at the pendant</source>
        <translation>Am Programmierhandgerät wird etwas bearbeitet</translation>
    </message>
    <message>
        <source>leave the editor there</source>
        <translation>dort den Editor verlassen</translation>
    </message>
    <message>
        <source>Another function uses the files</source>
        <translation>Eine andere Funktion benutzt die Dateien</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>gleich noch einmal versuchen</translation>
    </message>
    <message>
        <source>The data are protected</source>
        <translation>Die Daten sind geschützt</translation>
    </message>
    <message>
        <source>release the protection at the pendant</source>
        <translation>den Schutz am Programmierhandgerät aufheben</translation>
    </message>
    <message>
        <source>Replacing files is not permitted</source>
        <translation>Das Ersetzen von Dateien ist nicht zugelassen</translation>
    </message>
    <message>
        <source>set the parameters RS029 and RS214 to 1: %1</source>
        <translation>die Parameter RS029 und RS214 auf 1 setzen: %1</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION COND. oder FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or TEACHING COND.</source>
        <translation>SETUP, FUNCTION COND. oder TEACHING COND.</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE or TEACHING COND.</source>
        <translation>SETUP, FUNCTION ENABLE oder TEACHING COND.</translation>
    </message>
    <message>
        <source>PARAMETER, RS (management mode)</source>
        <translation>PARAMETER, RS (Managementmodus)</translation>
    </message>
    <message>
        <source>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)</source>
        <translation>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 bei einer DX100)</translation>
    </message>
    <message>
        <source>The controller shows an error</source>
        <translation>Die Steuerung zeigt einen Fehler</translation>
    </message>
    <message>
        <source>The controller shows no error</source>
        <translation>Die Steuerung zeigt keinen Fehler</translation>
    </message>
    <message>
        <source>there is nothing to cancel</source>
        <translation>es gibt nichts zu löschen</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>die Verbindung wurde getrennt</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>die Sprache wurde geändert</translation>
    </message>
    <message>
        <source>the window was turned to another controller</source>
        <translation>das Fenster wurde auf eine andere Steuerung umgestellt</translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation>der Rechner ging in den Ruhezustand</translation>
    </message>
    <message>
        <source>this program stood still, or the computer&apos;s clock jumped</source>
        <translation>dieses Programm stand still, oder die Uhr des Rechners sprang</translation>
    </message>
</context>
<context>
    <name>FileSheet</name>
    <message>
        <source>There is no “%1”.</source>
        <translation>„%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>Den Ordner „%1“ gibt es nicht.</translation>
    </message>
    <message>
        <source>“%1” exists already. Is it to be replaced?</source>
        <translation>„%1“ ist schon vorhanden. Soll es ersetzt werden?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>LinkView</name>
    <message>
        <source>checking</source>
        <translation>wird geprüft</translation>
    </message>
    <message>
        <source>live</source>
        <translation>live</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>Kommunikation verloren</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Diagnose…</source>
        <translation>Diagnose…</translation>
    </message>
    <message>
        <source>HOLD not confirmed: use the pendant.</source>
        <translation>HOLD nicht bestätigt: Programmierhandgerät benutzen.</translation>
    </message>
    <message>
        <source>HOLD was refused: %1. Use the pendant.</source>
        <translation>HOLD wurde abgelehnt: %1. Programmierhandgerät benutzen.</translation>
    </message>
    <message>
        <source>No contact with %1 yet: %2. Checking goes on by itself.</source>
        <translation>Noch kein Kontakt zu %1: %2. Die Prüfung läuft von selbst weiter.</translation>
    </message>
    <message>
        <source>Checking %1: waiting for system information and status.</source>
        <translation>%1 wird geprüft: warten auf Systeminformationen und Status.</translation>
    </message>
    <message>
        <source>Communication lost at %1 — showing the last values read. Reading resumes by itself.</source>
        <translation>Kommunikation um %1 verloren — angezeigt werden die zuletzt gelesenen Werte. Das Lesen läuft von selbst wieder an.</translation>
    </message>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>Kommunikation um %1 wiederhergestellt. Seit dem Verbinden %n-mal verloren.</numerusform>
            <numerusform>Kommunikation um %1 wiederhergestellt. Seit dem Verbinden %n-mal verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>HOLD was not sent: there is no connection to a controller. Use the pendant.</source>
        <translation>HOLD wurde nicht gesendet: Es besteht keine Verbindung zu einer Steuerung. Programmierhandgerät benutzen.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Verbinden…</translation>
    </message>
</context>
<context>
    <name>Noise</name>
    <message>
        <source>Date of the last change of a job (///DATE)</source>
        <translation>Datum der letzten Änderung eines Jobs (///DATE)</translation>
    </message>
    <message>
        <source>Dates and times of day, such as 2026/01/31 08:30</source>
        <translation>Datumsangaben und Uhrzeiten, zum Beispiel 2026/01/31 08:30</translation>
    </message>
    <message>
        <source>Operating time counters, such as 18:19&apos;02</source>
        <translation>Betriebszeitzähler, zum Beispiel 18:19&apos;02</translation>
    </message>
    <message>
        <source>Blanks at the end of a line</source>
        <translation>Leerzeichen am Ende einer Zeile</translation>
    </message>
    <message>
        <source>Line ends: CR LF or LF, and whether the last line has one</source>
        <translation>Zeilenenden: CR LF oder LF, und ob die letzte Zeile eines hat</translation>
    </message>
</context>
<context>
    <name>OrderRecords</name>
    <message>
        <source>✓ done</source>
        <translation>✓ erledigt</translation>
    </message>
    <message>
        <source>✗ refused</source>
        <translation>✗ abgelehnt</translation>
    </message>
    <message>
        <source>▲ unknown</source>
        <translation>▲ unbekannt</translation>
    </message>
    <message>
        <source>□ not sent</source>
        <translation>□ nicht gesendet</translation>
    </message>
    <message>
        <source>□ cancelled</source>
        <translation>□ abgebrochen</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>kept on this computer</source>
        <translation>auf diesem Rechner aufbewahrt</translation>
    </message>
    <message>
        <source>the last values read before %1</source>
        <translation>die letzten vor %1 gelesenen Werte</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/A</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>Tippbetrieb und Bewegen</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Trend</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Jobs</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works.</source>
        <translation>Der Zustand des Roboters auf einen Blick: Betriebsart, Zyklus, Servo, Lauf, die drei Ursachen für HOLD, Alarm, Fehler und Geschwindigkeitsgrenze, der Job in Ausführung, die Position von R1 und wie gut die Verbindung arbeitet.</translation>
    </message>
    <message>
        <source>“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it.</source>
        <translation>„Was ist jetzt möglich?“ führt auf, was befohlen werden darf. ✓ darf versucht werden, ✗ nicht; der erste Grund steht daneben.</translation>
    </message>
    <message>
        <source>Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲.</source>
        <translation>Bits, die einander widersprechen, zum Beispiel TEACH und PLAY, werden nebeneinander so gezeigt, wie sie empfangen wurden, unter ▲.</translation>
    </message>
    <message>
        <source>Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend.</source>
        <translation>„Kopieren“ neben den Systeminformationen legt Modell und Software in die Zwischenablage. Die rechte Maustaste auf einer Zahl fügt diese zum Trend hinzu.</translation>
    </message>
    <message>
        <source>Up to four active alarms, the newest first, and the past alarms that were read from the controller.</source>
        <translation>Bis zu vier anstehende Alarme, der neueste zuerst, und die vergangenen Alarme, die aus der Steuerung gelesen wurden.</translation>
    </message>
    <message>
        <source>Acknowledge is noted on this computer only: the robot does not hear of it.</source>
        <translation>„Quittieren“ wird nur auf diesem Rechner vermerkt: Der Roboter erfährt davon nichts.</translation>
    </message>
    <message>
        <source>Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there.</source>
        <translation>„Alarm zurücksetzen“ und „Fehler löschen“ sind Befehle: Sie brauchen REMOTE und die Stufe Bedienen und sagen vorher, was sie zurücksetzen oder löschen. Nach einem angenommenen Zurücksetzen kann ein Alarm bestehen bleiben: Dann ist seine Ursache noch da.</translation>
    </message>
    <message>
        <source>Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes.</source>
        <translation>„Jetzt lesen“ holt den Verlauf und bewahrt ihn im Journal auf, auch wenn die Steuerung ihn schon verworfen hat. „Häufigste“ zählt Codes.</translation>
    </message>
    <message>
        <source>Notes keep what caused a code and what was done, on this computer.</source>
        <translation>„Notizen“ bewahren auf diesem Rechner auf, was einen Code verursacht hat und was getan wurde.</translation>
    </message>
    <message>
        <source>All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds.</source>
        <translation>Alle Signale eines Bereichs, je Zeile eine Gruppe von acht. Ein gefülltes Quadrat ist 1, ein leeres 0; ein Rahmen markiert, was sich in den letzten zwei Sekunden geändert hat.</translation>
    </message>
    <message>
        <source>Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together.</source>
        <translation>Über HSES lassen sich nur Netzwerkeingänge schreiben, auf der Stufe Einrichten. Ein Schreibvorgang liest die Gruppe, ändert ein Bit, zeigt alt und neu und liest zurück: Acht Bits werden zusammen übertragen.</translation>
    </message>
    <message>
        <source>Names come from the controller&apos;s IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch.</source>
        <translation>Die Namen stammen aus IONAME.DAT der Steuerung. Mit der rechten Maustaste wird ein Signal hier benannt oder auf die Registerkarte „Beobachten“ gesetzt.</translation>
    </message>
    <message>
        <source>Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen.</source>
        <translation>„Beobachten“ zählt Flanken und zeichnet die letzte Minute. Gelesen wird viermal pro Sekunde: Kürzere Impulse bleiben unbemerkt.</translation>
    </message>
    <message>
        <source>Go to takes #27010 as well as IN#(1).</source>
        <translation>„Gehe zu“ nimmt #27010 ebenso an wie IN#(1).</translation>
    </message>
    <message>
        <source>The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read.</source>
        <translation>Die Register M000 bis M999 als Dezimalzahlen, Zahlen mit Vorzeichen, Hexadezimal- oder Binärzahlen. Nur die sichtbaren Zeilen werden gelesen.</translation>
    </message>
    <message>
        <source>M000 to M559 can be written by an engineer; the others belong to the ladder.</source>
        <translation>M000 bis M559 lassen sich auf der Stufe Einrichten schreiben; die übrigen gehören dem Kontaktplan (Ladder).</translation>
    </message>
    <message>
        <source>Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back.</source>
        <translation>Die Eingabetaste merkt im Editor einen Wert vor: Er wird bernsteinfarben, und nichts wird gesendet. „Anwenden“ zeigt alt und neu aller vorgemerkten Werte, schreibt jeden einmal und liest ihn zurück.</translation>
    </message>
    <message>
        <source>A value that reads back differently is red and stays. Undo last stages the values from before the last Apply.</source>
        <translation>Ein Wert, der abweichend zurückgelesen wird, ist rot und bleibt stehen. „Letztes rückgängig“ merkt die Werte von vor dem letzten „Anwenden“ vor.</translation>
    </message>
    <message>
        <source>The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read.</source>
        <translation>Die Variablen B I D R S P BP und EX mit ihren Namen, ihrem vorherigen Wert und dem Zeitpunkt ihrer Änderung. Nur die sichtbaren Zeilen werden gelesen.</translation>
    </message>
    <message>
        <source>Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads.</source>
        <translation>Es wird nichts geschrieben, bevor die Nummerierung mit dem Programmierhandgerät verglichen wurde: „Prüfen…“ tut das und liest nur.</translation>
    </message>
    <message>
        <source>Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ.</source>
        <translation>„Importieren…“ und „Exportieren…“ arbeiten mit CSV-Dateien; Zellen einer Tabellenkalkulation lassen sich einfügen. Beim Importieren und Einfügen wird zuerst gezeigt, was sich ändern würde.</translation>
    </message>
    <message>
        <source>A watch page is a list of your own: the right mouse button puts rows of any tab on it.</source>
        <translation>Eine Beobachtungsseite ist eine eigene Liste: Die rechte Maustaste setzt Zeilen jeder Registerkarte darauf.</translation>
    </message>
    <message>
        <source>The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point.</source>
        <translation>Der Werkzeugpunkt im Basiskoordinatensystem mit Stellung und Werkzeug; die Achsen in Impulsen mit Schleppfehler, Drehmoment und Temperatur, soweit das Modell sie nennt; und die Bahn des Werkzeugpunkts.</translation>
    </message>
    <message>
        <source>Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them.</source>
        <translation>Grad der Achsen stehen hier nur, wenn das Profil die Impulse pro Grad angibt: Die Steuerung nennt sie nicht.</translation>
    </message>
    <message>
        <source>Torque is shown as the controller sends it: its unit is stated nowhere.</source>
        <translation>Das Drehmoment wird so gezeigt, wie die Steuerung es sendet: Seine Einheit ist nirgends angegeben.</translation>
    </message>
    <message>
        <source>Min and max count from the last reset, while this page is read. Copy as text takes the table in view.</source>
        <translation>Min. und Max. gelten seit dem letzten Zurücksetzen, soweit diese Seite gelesen wurde. „Als Text kopieren“ übernimmt die sichtbare Tabelle.</translation>
    </message>
    <message>
        <source>Control groups that the controller refuses have no tab; the line beside the tabs counts them.</source>
        <translation>Achsgruppen, die die Steuerung ablehnt, haben keine Registerkarte; die Zeile neben den Registerkarten nennt ihre Anzahl.</translation>
    </message>
    <message>
        <source>Moves the robot by orders, in automatic operation. The pendant&apos;s enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always.</source>
        <translation>Bewegt den Roboter durch Befehle, im Automatikbetrieb. Der Zustimmungsschalter des Programmierhandgeräts schützt hier niemanden, und niemand darf sich innerhalb des Schutzzauns aufhalten. In TEACH ist dies immer gesperrt.</translation>
    </message>
    <message>
        <source>Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms.</source>
        <translation>Scharfschalten erfordert die Stufe Bedienen, REMOTE und PLAY; Bewegen erfordert außerdem die Stufe Einrichten. Der Verlust des Fokus, eine Minute ohne Tastatur oder Maus, ein Alarm oder eine verlorene Verbindung schaltet unscharf.</translation>
    </message>
    <message>
        <source>Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step.</source>
        <translation>„Tippbetrieb“ sendet einen begrenzten Schritt nach dem anderen, solange eine Schaltfläche gedrückt gehalten wird. Nach dem Loslassen wird kein weiterer Schritt gesendet und der laufende mit HOLD angehalten; nach Verlust der Verbindung führt der Roboter seinen Schritt noch zu Ende.</translation>
    </message>
    <message>
        <source>Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed.</source>
        <translation>„Bewegen“ zeigt zuerst aktuelle Position, Ziel und Änderung. „Vorab prüfen…“ öffnet das Fenster, in dem die Bewegung bestätigt wird.</translation>
    </message>
    <message>
        <source>What was sent without an answer is called unknown, never failed: look at the robot.</source>
        <translation>Was gesendet wurde und ohne Antwort blieb, heißt unbekannt, nie fehlgeschlagen: Sehen Sie nach dem Roboter.</translation>
    </message>
    <message>
        <source>Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal….</source>
        <translation>Zeichnet jede Zahl über der Zeit auf. Ziehen Sie sie von einer Seite hierher, wählen Sie „Zum Trend hinzufügen“ in ihrem Menü, oder benutzen Sie „Signal hinzufügen…“.</translation>
    </message>
    <message>
        <source>Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read.</source>
        <translation>„Pause“ hält die Ansicht an; die Aufzeichnung läuft weiter. Lücken in einer Kurve sind Zeiten, in denen nichts gelesen wurde.</translation>
    </message>
    <message>
        <source>The time box chooses how long a time is in view; under the cursor stand the values of that moment.</source>
        <translation>Das Zeitfeld legt fest, welche Zeitspanne im Bild ist; beim Cursor stehen die Werte dieses Zeitpunkts.</translation>
    </message>
    <message>
        <source>An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later.</source>
        <translation>Ein Vorfall bewahrt 60 s vor und 20 s nach dem Auftreten eines Alarms auf. Er lässt sich hier später öffnen.</translation>
    </message>
    <message>
        <source>Export CSV… writes what is in view, with times in UTC.</source>
        <translation>„CSV exportieren…“ schreibt, was im Bild ist, mit Zeiten in UTC.</translation>
    </message>
    <message>
        <source>The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old.</source>
        <translation>Die Jobs auf der Steuerung und der Text des gewählten, mit der Zeile, die ausgeführt wird. Ein Hinweis sagt, wenn der Text veraltet sein kann.</translation>
    </message>
    <message>
        <source>Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice.</source>
        <translation>Ein Start erfordert REMOTE, PLAY, Servo ein, die Stufe Bedienen und eine scharfe Steuerung. Sein Fenster nennt Steuerung, Job und Zeile, und die Schaltfläche ist erst nach einer Sekunde wirksam. Nichts wird je zweimal gestartet.</translation>
    </message>
    <message>
        <source>Buttons show what was read. “Pending” stands until the status agrees.</source>
        <translation>Schaltflächen zeigen, was gelesen wurde. „Ausstehend“ steht da, bis der Status übereinstimmt.</translation>
    </message>
    <message>
        <source>HOLD from here can be released here. A hold by the pendant is released there.</source>
        <translation>HOLD von hier lässt sich hier aufheben. HOLD vom Programmierhandgerät wird dort aufgehoben.</translation>
    </message>
    <message>
        <source>“Why not?” beside a button lists all its conditions.</source>
        <translation>„Warum nicht?“ neben einer Schaltfläche führt alle ihre Bedingungen auf.</translation>
    </message>
    <message>
        <source>Files of this computer on the left, of the controller on the right, by type.</source>
        <translation>Dateien dieses Rechners links, der Steuerung rechts, nach Typ.</translation>
    </message>
    <message>
        <source>Fetch only reads. Send and Delete are for engineers and need REMOTE on.</source>
        <translation>„Holen“ liest nur. „Senden“ und „Löschen“ erfordern die Stufe Einrichten und eingeschaltetes REMOTE.</translation>
    </message>
    <message>
        <source>A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one.</source>
        <translation>Zu einer Datei, die schon vorhanden ist, wird gefragt: vergleichen, ersetzen oder unberührt lassen; Letzteres ist die Vorgabe. Eine unvollständig übertragene Datei ersetzt nie eine gute.</translation>
    </message>
    <message>
        <source>Before a job is sent its text is checked, and afterwards it is read back and compared.</source>
        <translation>Bevor ein Job gesendet wird, wird sein Text geprüft, und danach wird er zurückgelesen und verglichen.</translation>
    </message>
    <message>
        <source>Transfers lists every file with its bytes and state. Retry failed sends none that was finished.</source>
        <translation>„Übertragungen“ führt jede Datei mit ihren Bytes und ihrem Zustand auf. „Fehlgeschlagene wiederholen“ sendet keine, die fertig war.</translation>
    </message>
    <message>
        <source>Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole.</source>
        <translation>Sicherungen dieser Steuerung, die neueste zuerst, mit den Dateien, die in jeder fehlen. ▲ markiert eine, die nicht vollständig ist.</translation>
    </message>
    <message>
        <source>Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest.</source>
        <translation>„Jetzt sichern“ liest jede Datei in einen neuen Ordner, mit einer Prüfsumme für jede. Eine Datei, die fehlschlägt, hält die übrigen nicht auf.</translation>
    </message>
    <message>
        <source>Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which.</source>
        <translation>„Prüfen“ liest jedes Byte noch einmal. „Vergleichen“ findet, was von einer anderen Sicherung oder von der Steuerung jetzt abweicht; Datumsangaben und Zähler werden ausgelassen, und die Seite sagt, welche.</translation>
    </message>
    <message>
        <source>Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run.</source>
        <translation>„Zurückspielen…“ plant zuerst, legt eine frische Sicherung an, sendet, was sich geändert hat, und liest es zurück. Es erfordert die Stufe Einrichten und REMOTE, und kein Job darf laufen.</translation>
    </message>
    <message>
        <source>Old backups go by number and age as set below the list, never the last good one or a pinned one.</source>
        <translation>Alte Sicherungen werden nach Anzahl und Alter gelöscht, wie unter der Liste eingestellt, nie die letzte gute oder eine angeheftete.</translation>
    </message>
    <message>
        <source>Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller&apos;s answer.</source>
        <translation>Alles, was von hier versucht wurde: Schreibvorgänge, Starts, Bewegungen, Servo, Dateien und was abgelehnt oder nicht gesendet wurde, mit Benutzer, altem und neuem Wert und der Antwort der Steuerung.</translation>
    </message>
    <message>
        <source>“Unknown” means that no answer came: it may have happened.</source>
        <translation>„Unbekannt“ bedeutet, dass keine Antwort kam: Es kann geschehen sein.</translation>
    </message>
    <message>
        <source>Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down.</source>
        <translation>Filtern Sie nach Steuerung, Art, Zeit und Ausgang, oder suchen Sie in allen Texten. Ältere Einträge erscheinen beim Blättern nach unten.</translation>
    </message>
    <message>
        <source>The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows.</source>
        <translation>Das Journal wird auf diesem Rechner für alle Steuerungen geführt und lässt sich ohne Verbindung lesen. „Exportieren…“ schreibt, was der Filter zeigt.</translation>
    </message>
    <message>
        <source>Go to a signal</source>
        <translation>Zu einem Signal gehen</translation>
    </message>
    <message>
        <source>Write the signal (network inputs)</source>
        <translation>Das Signal schreiben (Netzwerkeingänge)</translation>
    </message>
    <message>
        <source>On the tab Watch: watch the signal no longer</source>
        <translation>Auf der Registerkarte „Beobachten“: das Signal nicht mehr beobachten</translation>
    </message>
    <message>
        <source>Go to a register</source>
        <translation>Zu einem Register gehen</translation>
    </message>
    <message>
        <source>Open the editor; in it: stage the value</source>
        <translation>Den Editor öffnen; darin: den Wert vormerken</translation>
    </message>
    <message>
        <source>Discard the staged value</source>
        <translation>Den vorgemerkten Wert verwerfen</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>Die gewählten Zeilen kopieren</translation>
    </message>
    <message>
        <source>Paste cells: they are staged after a preview</source>
        <translation>Zellen einfügen: Sie werden nach einer Vorschau vorgemerkt</translation>
    </message>
    <message>
        <source>Go to a variable</source>
        <translation>Zu einer Variablen gehen</translation>
    </message>
    <message>
        <source>Held on a jog button: steps, if keyboard jog was switched on</source>
        <translation>Auf einer Schaltfläche des Tippbetriebs gedrückt gehalten: Schritte, wenn der Tippbetrieb mit der Tastatur eingeschaltet wurde</translation>
    </message>
    <message>
        <source>In the sheet of the move, after typing its words: move</source>
        <translation>Im Fenster der Bewegung, nach Eingabe der verlangten Wörter: bewegen</translation>
    </message>
    <message>
        <source>In the plot: move the cursor</source>
        <translation>In der Kurve: den Cursor bewegen</translation>
    </message>
    <message>
        <source>In the plot: cursor to the oldest or newest time in view</source>
        <translation>In der Kurve: Cursor zur ältesten oder neuesten Zeit im Bild</translation>
    </message>
    <message>
        <source>In the plot: take the cursor away</source>
        <translation>In der Kurve: den Cursor entfernen</translation>
    </message>
    <message>
        <source>In the list of signals: remove it from the trend</source>
        <translation>In der Liste der Signale: aus dem Trend entfernen</translation>
    </message>
    <message>
        <source>In the start sheet, after typing its words: start</source>
        <translation>Im Startfenster, nach Eingabe der verlangten Wörter: starten</translation>
    </message>
    <message>
        <source>Copy the chosen rows of the list with the focus</source>
        <translation>Die gewählten Zeilen der Liste mit dem Fokus kopieren</translation>
    </message>
    <message>
        <source>“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which.</source>
        <translation>„Job“ ist der Job, den die Steuerung nennt: im Stillstand der, den ein Start beginnen würde, sonst der laufende. „Lauf“ sagt, welcher es ist.</translation>
    </message>
    <message>
        <source>All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order.</source>
        <translation>Alle Steuerungen nebeneinander: zuerst die mit Alarm, dann die ohne Verbindung und die gehaltenen, dann die übrigen in fester Reihenfolge.</translation>
    </message>
    <message>
        <source>A click opens a controller’s pages. The others stay connected and are read once a second.</source>
        <translation>Ein Klick öffnet die Seiten einer Steuerung. Die anderen bleiben verbunden und werden einmal pro Sekunde gelesen.</translation>
    </message>
    <message>
        <source>HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop.</source>
        <translation>HOLD ALLE gibt an jede Steuerung, die nicht AUS ist, ein Software-HOLD, fragt nicht nach und sagt von jeder, ob es bestätigt wurde. Es ist kein Not-Halt.</translation>
    </message>
    <message>
        <source>Connect all and Back up all only read. Nothing else goes to several controllers at once.</source>
        <translation>„Alle verbinden“ und „Alle sichern“ lesen nur. Sonst geht nichts an mehrere Steuerungen zugleich.</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Flotte</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
</context>
<context>
    <name>Readiness</name>
    <message>
        <source>A signal group and a B variable were asked for: %1.</source>
        <translation>Eine Signalgruppe und eine B-Variable wurden abgefragt: %1.</translation>
    </message>
    <message>
        <source>A signal group and a B variable are asked for while this sheet is open. Writing needs no REMOTE; whether data are protected cannot be read.</source>
        <translation>Eine Signalgruppe und eine B-Variable werden abgefragt, solange dieses Fenster offen ist. Schreiben braucht kein REMOTE; ob Daten geschützt sind, ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The software version, which tells the model, was not read yet.</source>
        <translation>Die Softwareversion, die das Modell erkennen lässt, wurde noch nicht gelesen.</translation>
    </message>
    <message>
        <source>The profile says %1, but %2 is the software of a %3.</source>
        <translation>Das Profil sagt %1, aber %2 ist die Software einer %3.</translation>
    </message>
    <message>
        <source>The software %1 does not tell the model. The ranges are those of the profile&apos;s %2.</source>
        <translation>Die Software %1 lässt das Modell nicht erkennen. Es gelten die Bereiche der %2 aus dem Profil.</translation>
    </message>
    <message>
        <source>The software %1 is that of a %2. Its ranges come from a table, not from the controller.</source>
        <translation>Die Software %1 ist die einer %2. Deren Bereiche stammen aus einer Tabelle, nicht von der Steuerung.</translation>
    </message>
    <message>
        <source>The last HOLD was refused: %1.</source>
        <translation>Das letzte HOLD wurde abgelehnt: %1.</translation>
    </message>
    <message>
        <source>The last HOLD was confirmed by the status. It is a software hold, no emergency stop.</source>
        <translation>Das letzte HOLD wurde durch den Status bestätigt. Es ist ein Softwarehalt, kein Not-Halt.</translation>
    </message>
    <message>
        <source>The last HOLD was sent, and the status did not confirm it.</source>
        <translation>Das letzte HOLD wurde gesendet, und der Status hat es nicht bestätigt.</translation>
    </message>
    <message>
        <source>It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.</source>
        <translation>Es braucht weder REMOTE noch eine Zugriffsstufe und wurde nicht erprobt. Es ist ein Softwarehalt, kein Not-Halt.</translation>
    </message>
    <message>
        <source>A list of jobs was asked for at port %1: %2.</source>
        <translation>Eine Jobliste wurde an Port %1 abgefragt: %2.</translation>
    </message>
    <message>
        <source>A list of jobs is asked for at port %1.</source>
        <translation>Eine Jobliste wird an Port %1 abgefragt.</translation>
    </message>
    <message>
        <source>Port %1 lists the jobs. Sending and deleting files need REMOTE.</source>
        <translation>Port %1 listet die Jobs auf. Senden und Löschen von Dateien brauchen REMOTE.</translation>
    </message>
    <message>
        <source>This simulation has B000 at number %1 on the network.</source>
        <translation>In dieser Simulation hat B000 im Netzwerk die Nummer %1.</translation>
    </message>
    <message>
        <source>The software version, with which it was compared, was not read yet.</source>
        <translation>Die Softwareversion, mit der verglichen wurde, wurde noch nicht gelesen.</translation>
    </message>
    <message>
        <source>It was compared with software %1, but %2 runs now: variables are not written before it is compared again.</source>
        <translation>Verglichen wurde mit Software %1, jetzt läuft aber %2: Variablen werden nicht geschrieben, bevor erneut verglichen wurde.</translation>
    </message>
    <message>
        <source>Whether B000 is number 0 or 1 on the network is unverified; variables are not written.</source>
        <translation>Ob B000 im Netzwerk die Nummer 0 oder 1 hat, ist nicht geprüft; Variablen werden nicht geschrieben.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1: number 0 on the network is B000.</source>
        <translation>Mit dem Programmierhandgerät verglichen am %1: Nummer 0 im Netzwerk ist B000.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1, shifted: number 1 on the network is B000.</source>
        <translation>Mit dem Programmierhandgerät verglichen am %1, verschoben: Nummer 1 im Netzwerk ist B000.</translation>
    </message>
    <message>
        <source>The controller does not answer any more. Reading resumes by itself.</source>
        <translation>Die Steuerung antwortet nicht mehr. Das Lesen läuft von selbst wieder an.</translation>
    </message>
    <message>
        <source>The controller tells its status and system information. Reading needs no REMOTE.</source>
        <translation>Die Steuerung nennt ihren Status und ihre Systeminformationen. Lesen braucht kein REMOTE.</translation>
    </message>
    <message>
        <source>Orders are taken in command remote alone: start, select, reset, cycle, servo on.</source>
        <translation>Befehle werden nur mit CMD REMOTE angenommen: Start, Wählen, Zurücksetzen, Zyklus, Servo ein.</translation>
    </message>
    <message>
        <source>It needs REMOTE, and that no job runs.</source>
        <translation>Es braucht REMOTE, und es darf kein Job laufen.</translation>
    </message>
    <message>
        <source>It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.</source>
        <translation>Es braucht PLAY, REMOTE, Servo ein und einen Job, und nichts darf den Roboter halten.</translation>
    </message>
    <message>
        <source>It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken without REMOTE is up to the controller.</source>
        <translation>Es braucht PLAY und REMOTE. Servo aus lässt sich von hier immer befehlen; ob es ohne REMOTE angenommen wird, hängt von der Steuerung ab.</translation>
    </message>
    <message>
        <source>They need what a start needs, but for the job, and a model that knows them.</source>
        <translation>Sie brauchen dasselbe wie ein Start, nur keinen Job, und dazu ein Modell, das sie kennt.</translation>
    </message>
    <message>
        <source>Sending a file that exists there needs REMOTE and two parameters.</source>
        <translation>Das Senden einer Datei, die dort vorhanden ist, braucht REMOTE und zwei Parameter.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>I/O and variables</source>
        <translation>E/A und Variablen</translation>
    </message>
    <message>
        <source>Ranges of the model</source>
        <translation>Bereiche des Modells</translation>
    </message>
    <message>
        <source>Orders (REMOTE)</source>
        <translation>Befehle (REMOTE)</translation>
    </message>
    <message>
        <source>Selecting a job</source>
        <translation>Einen Job wählen</translation>
    </message>
    <message>
        <source>Starting a job</source>
        <translation>Einen Job starten</translation>
    </message>
    <message>
        <source>Switching servo on</source>
        <translation>Servo einschalten</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>Tippbetrieb und Bewegen</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (Software)</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Replacing files</source>
        <translation>Dateien ersetzen</translation>
    </message>
    <message>
        <source>Numbering of variables</source>
        <translation>Nummerierung der Variablen</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>erlaubt</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>vermutet</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>In the way: %1.</source>
        <translation>Dem steht entgegen: %1.</translation>
    </message>
    <message>
        <source>HSES does not tell whether this is so: %1.</source>
        <translation>Ob dies zutrifft, sagt HSES nicht: %1.</translation>
    </message>
    <message>
        <source>What helps: %1.</source>
        <translation>Abhilfe: %1.</translation>
    </message>
    <message>
        <source>Diagnose… in the rail finds out at which step it fails.</source>
        <translation>„Diagnose…“ in der Seitenleiste stellt fest, an welchem Schritt es scheitert.</translation>
    </message>
    <message>
        <source>Correct the model in the profile (Connect…).</source>
        <translation>Berichtigen Sie das Modell im Profil („Verbinden…“).</translation>
    </message>
    <message>
        <source>Use the pendant.</source>
        <translation>Programmierhandgerät benutzen.</translation>
    </message>
    <message>
        <source>Pendesk %1, readiness of %2 (%3), %4, %5</source>
        <translation>Pendesk %1, Bereitschaft von %2 (%3), %4, %5</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>subject, allowance, evidence</comment>
        <translation>%1: %2, %3</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>Die Zeile hat nicht die Zahlen, die dorthin gehören.</translation>
    </message>
</context>
<context>
    <name>Shown</name>
    <message>
        <source>Not read yet.</source>
        <translation>Noch nicht gelesen.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Last seen %1</source>
        <translation>Zuletzt gesehen %1</translation>
    </message>
    <message>
        <source>not taught</source>
        <translation>nicht geteacht</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>HELD</source>
        <translation>GEHALTEN</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>PENDANT</source>
        <translation>HANDGERÄT</translation>
    </message>
    <message>
        <source>EXTERNAL</source>
        <translation>EXTERN</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>BEFEHL</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>NO MODE</source>
        <translation>KEIN MODUS</translation>
    </message>
    <message>
        <source>REMOTE %1</source>
        <translation>REMOTE %1</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>SCHRITT</translation>
    </message>
    <message>
        <source>1 CYCLE</source>
        <translation>1 ZYKLUS</translation>
    </message>
    <message>
        <source>CONTINUOUS</source>
        <translation>DAUERLAUF</translation>
    </message>
    <message>
        <source>NO CYCLE</source>
        <translation>KEIN ZYKLUS</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>LÄUFT</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>ON</source>
        <translation>EIN</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>AUS</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>ALARM</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>FEHLER</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>widersprüchlich</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>untätig</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>line %1 · step %2 · %3</source>
        <translation>Zeile %1 · Schritt %2 · %3</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>Impulse</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>HOLD asked for, %1 s…</source>
        <translation>HOLD angefordert, %1 s…</translation>
    </message>
    <message>
        <source>held by command</source>
        <translation>durch Befehl gehalten</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>vom Programmierhandgerät gehalten</translation>
    </message>
    <message>
        <source>held externally</source>
        <translation>extern gehalten</translation>
    </message>
    <message>
        <source>HOLD refused</source>
        <translation>HOLD abgelehnt</translation>
    </message>
    <message>
        <source>HOLD not confirmed</source>
        <translation>HOLD nicht bestätigt</translation>
    </message>
    <message>
        <source>released</source>
        <translation>aufgehoben</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>Softwarehalt · Pause-Taste</translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message>
        <source>%1 changed</source>
        <translation>%1 geändert</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>%1: gone.</source>
        <translation>%1: weggefallen.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>%n Zeile weicht ab, ab Zeile %1.</numerusform>
            <numerusform>%n Zeilen weichen ab, ab Zeile %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The newer file is empty; what stood in it is not known to be deleted.</source>
        <translation>Die neuere Datei ist leer; ob das, was darin stand, gelöscht ist, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The older file is empty.</source>
        <translation>Die ältere Datei ist leer.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>Und %n weiterer Unterschied.</numerusform>
            <numerusform>Und %n weitere Unterschiede.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes; the content differs.</source>
        <translation>%1 Bytes; der Inhalt weicht ab.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>moved %1 mm (%2)</source>
        <translation>um %1 mm verschoben (%2)</translation>
    </message>
    <message>
        <source>turned %1 deg (%2)</source>
        <translation>um %1 Grad gedreht (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>Von %n Job benutzt.</numerusform>
            <numerusform>Von %n Jobs benutzt.</numerusform>
        </translation>
    </message>
    <message>
        <source>could not be read in one of the files</source>
        <translation>konnte in einer der Dateien nicht gelesen werden</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>Name %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>weight %1 kg</source>
        <translation>Gewicht %1 kg</translation>
    </message>
    <message>
        <source>centre of gravity %1 mm</source>
        <translation>Schwerpunkt %1 mm</translation>
    </message>
    <message>
        <source>inertia %1 kgm²</source>
        <translation>Trägheit %1 kgm²</translation>
    </message>
    <message>
        <source>kind of entry %1</source>
        <translation>Art der Eingabe %1</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>%1 ist neu.</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1 ist weggefallen.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Werkzeug %1</translation>
    </message>
    <message>
        <source>User frame %1</source>
        <translation>Benutzerkoordinatensystem %1</translation>
    </message>
    <message>
        <source>where it lies could not be read in one of the files</source>
        <translation>seine Lage konnte in einer der Dateien nicht gelesen werden</translation>
    </message>
    <message>
        <source>taught with tool %1</source>
        <translation>geteacht mit Werkzeug %1</translation>
    </message>
    <message>
        <source>taught at other points</source>
        <translation>an anderen Punkten geteacht</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>Bereich %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>no longer set</source>
        <translation>nicht mehr gesetzt</translation>
    </message>
    <message>
        <source>upper %1 %2 mm</source>
        <translation>obere Grenze %1 %2 mm</translation>
    </message>
    <message>
        <source>lower %1 %2 mm</source>
        <translation>untere Grenze %1 %2 mm</translation>
    </message>
    <message>
        <source>other coordinates or another group</source>
        <translation>andere Koordinaten oder eine andere Gruppe</translation>
    </message>
    <message>
        <source>Collision detection, set %1, group %2</source>
        <translation>Kollisionserkennung, Satz %1, Gruppe %2</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>eingeschaltet</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>robot %1 limit %2 %3 %4 deg</source>
        <translation>Roboter %1 Grenze %2 %3 %4 Grad</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>meaning not known</source>
        <translation>Bedeutung nicht bekannt</translation>
    </message>
    <message>
        <source>Section %1 has %2 values.</source>
        <translation>Abschnitt %1 hat %2 Werte.</translation>
    </message>
    <message>
        <source>System part</source>
        <translation>Systemteil</translation>
    </message>
    <message>
        <source>User part</source>
        <translation>Benutzerteil</translation>
    </message>
    <message>
        <source>decides %1</source>
        <translation>bestimmt %1</translation>
    </message>
    <message>
        <source>%1, instruction %2: %3</source>
        <translation>%1, Anweisung %2: %3</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>aus %1 wurde %2</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1 ist neu</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 ist weggefallen</translation>
    </message>
    <message>
        <source>Now also written: %1.</source>
        <translation>Jetzt auch geschrieben: %1.</translation>
    </message>
    <message>
        <source>No longer written: %1.</source>
        <translation>Nicht mehr geschrieben: %1.</translation>
    </message>
    <message>
        <source>The control group %1 is another one.</source>
        <translation>Die Achsgruppe %1 ist eine andere.</translation>
    </message>
    <message>
        <source>Another number of control groups.</source>
        <translation>Eine andere Anzahl von Achsgruppen.</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>The hours of control power went back by %1: another controller, or its memory was cleared.</source>
        <translation>Die Betriebsstunden der Steuerspannung gingen um %1 zurück: eine andere Steuerung, oder ihr Speicher wurde gelöscht.</translation>
    </message>
    <message>
        <source>%1 powered in between.</source>
        <translation>Dazwischen %1 eingeschaltet.</translation>
    </message>
    <message>
        <source>Section %1 is new.</source>
        <translation>Abschnitt %1 ist neu.</translation>
    </message>
    <message>
        <source>Section %1 is not in the newer file.</source>
        <translation>Abschnitt %1 ist nicht in der neueren Datei.</translation>
    </message>
    <message>
        <source>Presets of timers and counters changed.</source>
        <translation>Vorgabewerte von Timern und Zählern geändert.</translation>
    </message>
    <message>
        <source>Home position of %1 axis %2 recalibrated (%3): taught points may be off.</source>
        <translation>Home-Position von %1 Achse %2 neu kalibriert (%3): Geteachte Punkte können abweichen.</translation>
    </message>
    <message>
        <source>Position of %1 axis %2: %3 pulses.</source>
        <translation>Position von %1 Achse %2: %3 Impulse.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source> Command remote select: HSES control is permitted.</source>
        <translation> CMD REMOTE: Steuerung über HSES ist zugelassen.</translation>
    </message>
    <message>
        <source> Command remote select: HSES control will be refused.</source>
        <translation> CMD REMOTE: Steuerung über HSES wird abgelehnt.</translation>
    </message>
    <message>
        <source>Pseudo input %1 switched %2.</source>
        <translation>Pseudoeingang %1 geschaltet: %2.</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Parameter version</source>
        <translation>Parameterversion</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>Anwendungen</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Platinen</translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>%n neuer Eintrag.</numerusform>
            <numerusform>%n neue Einträge.</numerusform>
        </translation>
    </message>
    <message>
        <source>The log rolled over: edits in between are not known.</source>
        <translation>Das Protokoll lief über: Bearbeitungen dazwischen sind nicht bekannt.</translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>%n neuer Alarm: %1.</numerusform>
            <numerusform>%n neue Alarme: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>coordinates %1</source>
        <translation>Koordinaten %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>Werkzeug %1</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>Benutzerkoordinatensystem %1</translation>
    </message>
    <message>
        <source>form of the arm</source>
        <translation>Armstellung</translation>
    </message>
    <message>
        <source>now set (%1)</source>
        <translation>jetzt gesetzt (%1)</translation>
    </message>
    <message>
        <source>Number of variables %1</source>
        <translation>Anzahl der Variablen %1</translation>
    </message>
    <message>
        <source>%1 lost its name “%2”.</source>
        <translation>%1 hat den Namen „%2“ verloren.</translation>
    </message>
    <message>
        <source>%1 is now named “%2”.</source>
        <translation>%1 heißt jetzt „%2“.</translation>
    </message>
    <message>
        <source>%1 “%2” is now named “%3”.</source>
        <translation>%1 „%2“ heißt jetzt „%3“.</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>read</source>
        <translation>gelesen</translation>
    </message>
    <message>
        <source>waited for</source>
        <translation>abgewartet</translation>
    </message>
    <message>
        <source>called</source>
        <translation>aufgerufen</translation>
    </message>
    <message>
        <source>jumped to</source>
        <translation>angesprungen</translation>
    </message>
    <message>
        <source>started</source>
        <translation>gestartet</translation>
    </message>
    <message>
        <source>named</source>
        <translation>benannt</translation>
    </message>
    <message>
        <source>may be %1</source>
        <translation>vielleicht %1</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 Zeile %2</translation>
    </message>
    <message>
        <source>%1 is called, and no file has it: %2.</source>
        <translation>%1 wird aufgerufen, und keine Datei enthält ihn: %2.</translation>
    </message>
    <message>
        <source>%1 is written in several places: %2.</source>
        <translation>%1 wird an mehreren Stellen geschrieben: %2.</translation>
    </message>
    <message>
        <source>%1 is read and never written in the files: %2.</source>
        <translation>%1 wird gelesen und in den Dateien nie geschrieben: %2.</translation>
    </message>
    <message>
        <source>%1 has several names: %2.</source>
        <translation>%1 hat mehrere Namen: %2.</translation>
    </message>
    <message>
        <source>%1 is used and its data were not entered: %2.</source>
        <translation>%1 wird benutzt, seine Daten sind nicht eingegeben: %2.</translation>
    </message>
    <message>
        <source>%1 is named by no other job and no macro.</source>
        <translation>%1 wird von keinem anderen Job und keinem Makro genannt.</translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message>
        <source>values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>Eintrag</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>collision detection</source>
        <translation>Kollisionserkennung</translation>
    </message>
    <message>
        <source>set</source>
        <translation>Satz</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>reasons of stops</source>
        <translation>Haltgründe</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>reasons</source>
        <translation>Gründe</translation>
    </message>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>Die Zeile hat nicht die Zahlen, die dorthin gehören.</translation>
    </message>
    <message>
        <source>The block has no number.</source>
        <translation>Der Block hat keine Nummer.</translation>
    </message>
    <message>
        <source>Tool %1 is not complete.</source>
        <translation>Werkzeug %1 ist nicht vollständig.</translation>
    </message>
    <message>
        <source>User frame %1 is not complete: where it lies is unknown.</source>
        <translation>Benutzerkoordinatensystem %1 ist nicht vollständig: Seine Lage ist unbekannt.</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>Benutzerkoordinatensysteme</translation>
    </message>
    <message>
        <source>Interference areas</source>
        <translation>Interferenzbereiche</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>Kollisionserkennung</translation>
    </message>
    <message>
        <source>Weaving conditions</source>
        <translation>Pendelbedingungen</translation>
    </message>
    <message>
        <source>Arc start conditions</source>
        <translation>Lichtbogen-Startbedingungen</translation>
    </message>
    <message>
        <source>Arc end conditions</source>
        <translation>Lichtbogen-Endbedingungen</translation>
    </message>
    <message>
        <source>Arc auxiliary conditions</source>
        <translation>Lichtbogen-Zusatzbedingungen</translation>
    </message>
    <message>
        <source>Welders</source>
        <translation>Schweißgeräte</translation>
    </message>
    <message>
        <source>Cutting shapes</source>
        <translation>Schneidformen</translation>
    </message>
    <message>
        <source>Maintenance conditions</source>
        <translation>Wartungsbedingungen</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>Names of variables</source>
        <translation>Namen der Variablen</translation>
    </message>
    <message>
        <source>Names of signals</source>
        <translation>Namen der Signale</translation>
    </message>
    <message>
        <source>Names of external signals</source>
        <translation>Namen der externen Signale</translation>
    </message>
    <message>
        <source>Names of registers</source>
        <translation>Namen der Register</translation>
    </message>
    <message>
        <source>Names of timers</source>
        <translation>Namen der Timer</translation>
    </message>
    <message>
        <source>Timers</source>
        <translation>Timer</translation>
    </message>
    <message>
        <source>Timer settings</source>
        <translation>Timer-Einstellungen</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Beobachtungsliste</translation>
    </message>
    <message>
        <source>Groups of signals</source>
        <translation>Signalgruppen</translation>
    </message>
    <message>
        <source>User words</source>
        <translation>Benutzerwörter</translation>
    </message>
    <message>
        <source>User menus</source>
        <translation>Benutzermenüs</translation>
    </message>
    <message>
        <source>Names of flags</source>
        <translation>Namen der Merker</translation>
    </message>
    <message>
        <source>Key functions</source>
        <translation>Tastenfunktionen</translation>
    </message>
    <message>
        <source>Interface panels</source>
        <translation>Bedienfelder (Interface Panel)</translation>
    </message>
    <message>
        <source>Macro commands</source>
        <translation>Makrobefehle</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>Kontaktplan (Ladder)</translation>
    </message>
    <message>
        <source>Pseudo inputs</source>
        <translation>Pseudoeingänge</translation>
    </message>
    <message>
        <source>I/O boards</source>
        <translation>E/A-Platinen</translation>
    </message>
    <message>
        <source>I/O axes</source>
        <translation>E/A-Achsen</translation>
    </message>
    <message>
        <source>EtherNet/IP</source>
        <translation>EtherNet/IP</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <source>Address translation</source>
        <translation>Adressumsetzung</translation>
    </message>
    <message>
        <source>Remote users</source>
        <translation>Fernbenutzer</translation>
    </message>
    <message>
        <source>Home positions of the encoders</source>
        <translation>Home-Positionen der Geber</translation>
    </message>
    <message>
        <source>Second home position</source>
        <translation>Zweite Home-Position</translation>
    </message>
    <message>
        <source>Operation origin</source>
        <translation>Arbeitsnullpunkt</translation>
    </message>
    <message>
        <source>Robot calibration</source>
        <translation>Roboterkalibrierung</translation>
    </message>
    <message>
        <source>Tool interference</source>
        <translation>Werkzeuginterferenz</translation>
    </message>
    <message>
        <source>Arrangement of robots</source>
        <translation>Anordnung der Roboter</translation>
    </message>
    <message>
        <source>Approach buzzer</source>
        <translation>Annäherungssummer</translation>
    </message>
    <message>
        <source>Servo assistance</source>
        <translation>Servounterstützung</translation>
    </message>
    <message>
        <source>Safety logic</source>
        <translation>Sicherheitslogik</translation>
    </message>
    <message>
        <source>Range limits</source>
        <translation>Bereichsgrenzen</translation>
    </message>
    <message>
        <source>Axis speed monitor</source>
        <translation>Achsgeschwindigkeitsüberwachung</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>Geschwindigkeitsgrenzen</translation>
    </message>
    <message>
        <source>Tool angle monitor</source>
        <translation>Werkzeugwinkelüberwachung</translation>
    </message>
    <message>
        <source>Check sums of safety data</source>
        <translation>Prüfsummen der Sicherheitsdaten</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>System, options and change dates</source>
        <translation>System, Optionen und Änderungsdaten</translation>
    </message>
    <message>
        <source>Operation log</source>
        <translation>Bedienprotokoll</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Alarmhistorie</translation>
    </message>
    <message>
        <source>Message history</source>
        <translation>Meldungshistorie</translation>
    </message>
    <message>
        <source>Fast events</source>
        <translation>Schnelle Ereignisse</translation>
    </message>
    <message>
        <source>Reasons of stops</source>
        <translation>Haltgründe</translation>
    </message>
    <message>
        <source>Maintenance counters</source>
        <translation>Wartungszähler</translation>
    </message>
    <message>
        <source>Torque counters</source>
        <translation>Drehmomentzähler</translation>
    </message>
    <message>
        <source>Encoder heat</source>
        <translation>Gebertemperatur</translation>
    </message>
    <message>
        <source>Step diagnosis</source>
        <translation>Schrittdiagnose</translation>
    </message>
    <message>
        <source>Job monitor</source>
        <translation>Jobüberwachung</translation>
    </message>
    <message>
        <source>Robot monitor</source>
        <translation>Roboterüberwachung</translation>
    </message>
    <message>
        <source>Servo monitor</source>
        <translation>Servoüberwachung</translation>
    </message>
    <message>
        <source>Regeneration unit</source>
        <translation>Rückspeiseeinheit</translation>
    </message>
    <message>
        <source>Memory image</source>
        <translation>Speicherabbild</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Unknown file</source>
        <translation>Unbekannte Datei</translation>
    </message>
    <message>
        <source>The file ends before the values of %1.</source>
        <translation>Die Datei endet vor den Werten von %1.</translation>
    </message>
    <message>
        <source>The control groups of this line could not be read.</source>
        <translation>Die Achsgruppen dieser Zeile konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>This section is not understood.</source>
        <translation>Dieser Abschnitt wird nicht verstanden.</translation>
    </message>
    <message>
        <source>“%1” is not understood.</source>
        <translation>„%1“ wird nicht verstanden.</translation>
    </message>
    <message>
        <source>The record in front of this date is not understood.</source>
        <translation>Der Datensatz vor diesem Datum wird nicht verstanden.</translation>
    </message>
    <message>
        <source>The record that begins here is not complete.</source>
        <translation>Der Datensatz, der hier beginnt, ist nicht vollständig.</translation>
    </message>
    <message>
        <source>The section %1 announces %2 records and holds %3.</source>
        <translation>Der Abschnitt %1 kündigt %2 Datensätze an und enthält %3.</translation>
    </message>
    <message>
        <source>The entry is numbered %1 and is number %2 by its place.</source>
        <translation>Der Eintrag trägt die Nummer %1 und ist nach seinem Platz Nummer %2.</translation>
    </message>
    <message>
        <source>The entry is not complete.</source>
        <translation>Der Eintrag ist nicht vollständig.</translation>
    </message>
    <message>
        <source>The number of the macro cannot be read.</source>
        <translation>Die Nummer des Makros kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The line holds NUL bytes.</source>
        <translation>Die Zeile enthält NUL-Bytes.</translation>
    </message>
    <message>
        <source>Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF before it is loaded.</source>
        <translation>Die Zeilen enden nur mit LF. Ein Programmierhandgerät kann eine solche Datei für leer halten: Vor dem Laden in CR LF umwandeln.</translation>
    </message>
    <message>
        <source>The file ends within a line: it may be cut.</source>
        <translation>Die Datei endet in einer Zeile: vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>The file is too long to be read.</source>
        <translation>Die Datei ist zu lang, um gelesen zu werden.</translation>
    </message>
    <message>
        <source>%1 has no section “%2”; the rows below it are not understood.</source>
        <translation>%1 hat keinen Abschnitt „%2“; die Zeilen darunter werden nicht verstanden.</translation>
    </message>
    <message>
        <source>The row has %1 instead of 10 values; the missing ones of %2 are unknown.</source>
        <translation>Die Zeile hat %1 statt 10 Werte; die fehlenden von %2 sind unbekannt.</translation>
    </message>
    <message>
        <source>%1 is no number of 32 bits.</source>
        <translation>%1 ist keine Zahl mit 32 Bit.</translation>
    </message>
    <message>
        <source>data transmission; 2 is over the network</source>
        <translation>Datenübertragung; 2 ist über das Netzwerk</translation>
    </message>
    <message>
        <source>numbering of variables for network clients; 1: by their number, 0: by their number plus one</source>
        <translation>Nummerierung der Variablen für Netzwerk-Clients; 1: nach ihrer Nummer, 0: nach ihrer Nummer plus eins</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files</source>
        <translation>1 erlaubt Netzwerk-Clients, Dateien zu überschreiben</translation>
    </message>
    <message>
        <source>serial transmission: data bits, parity, stop, speed, timers</source>
        <translation>serielle Übertragung: Datenbits, Parität, Stopp, Geschwindigkeit, Timer</translation>
    </message>
    <message>
        <source>3 permits overwriting when loading from USB</source>
        <translation>3 erlaubt Überschreiben beim Laden von USB</translation>
    </message>
    <message>
        <source>address and mask of the controller</source>
        <translation>Adresse und Maske der Steuerung</translation>
    </message>
    <message>
        <source>1 permits FTP</source>
        <translation>1 erlaubt FTP</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files; the meaning of 2 is not known</source>
        <translation>1 erlaubt Netzwerk-Clients, Dateien zu überschreiben; die Bedeutung von 2 ist nicht bekannt</translation>
    </message>
    <message>
        <source>addresses and masks</source>
        <translation>Adressen und Masken</translation>
    </message>
    <message>
        <source>0 permits selecting jobs in remote and play</source>
        <translation>0 erlaubt das Wählen von Jobs in REMOTE und PLAY</translation>
    </message>
    <message>
        <source>pendant operation in remote; 63 permits starts and edits</source>
        <translation>Handgerätebedienung in REMOTE; 63 erlaubt Starts und Bearbeitungen</translation>
    </message>
    <message>
        <source>alias function; 0 permits loading own names</source>
        <translation>Aliasfunktion; 0 erlaubt das Laden eigener Namen</translation>
    </message>
    <message>
        <source>drivers that start motion need 0</source>
        <translation>Treiber, die Bewegungen starten, brauchen 0</translation>
    </message>
    <message>
        <source>MotoPlus and telnet settings</source>
        <translation>Einstellungen für MotoPlus und Telnet</translation>
    </message>
    <message>
        <source>number of variables of each kind</source>
        <translation>Anzahl der Variablen jeder Art</translation>
    </message>
    <message>
        <source>control groups and their axes</source>
        <translation>Achsgruppen und ihre Achsen</translation>
    </message>
    <message>
        <source>pseudo input signals</source>
        <translation>Pseudoeingangssignale</translation>
    </message>
    <message>
        <source>The name “%1” holds bytes that the text encoding does not know.</source>
        <translation>Der Name „%1“ enthält Bytes, die die Textkodierung nicht kennt.</translation>
    </message>
    <message>
        <source>The row has more than four names.</source>
        <translation>Die Zeile hat mehr als vier Namen.</translation>
    </message>
    <message>
        <source>There are more names than signals.</source>
        <translation>Es gibt mehr Namen als Signale.</translation>
    </message>
    <message>
        <source>The row is not a number, two flags and a name.</source>
        <translation>Die Zeile ist nicht Zahl, zwei Kennzeichen und Name.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1 liegt jenseits der %n Variable, die die Datei ankündigt.</numerusform>
            <numerusform>%1 liegt jenseits der %n Variablen, die die Datei ankündigt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was named “%2” before; which name the pendant shows is not known.</source>
        <translation>%1 hieß zuvor „%2“; welchen Namen das Programmierhandgerät zeigt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The line stands in a section that names no signals.</source>
        <translation>Die Zeile steht in einem Abschnitt, der keine Signale benennt.</translation>
    </message>
    <message>
        <source>The line does not announce a number for each of the eight kinds.</source>
        <translation>Die Zeile kündigt nicht für jede der acht Arten eine Anzahl an.</translation>
    </message>
    <message>
        <source>The hours could not be read.</source>
        <translation>Die Betriebsstunden konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file does not say the version of the system software.</source>
        <translation>Die Datei nennt die Version der Systemsoftware nicht.</translation>
    </message>
    <message>
        <source>system</source>
        <translation>System</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>application</source>
        <translation>Anwendung</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1, %n Achse</numerusform>
            <numerusform>%1, %n Achsen</numerusform>
        </translation>
    </message>
    <message>
        <source>boards</source>
        <translation>Platinen</translation>
    </message>
    <message>
        <source>board</source>
        <translation>Platine</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>Stunden</translation>
    </message>
    <message>
        <source>counter</source>
        <translation>Zähler</translation>
    </message>
    <message>
        <source>options</source>
        <translation>Optionen</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>ladder</source>
        <translation>Kontaktplan (Ladder)</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>instruction</source>
        <translation>Anweisung</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>operation log</source>
        <translation>Bedienprotokoll</translation>
    </message>
    <message>
        <source>event</source>
        <translation>Ereignis</translation>
    </message>
    <message>
        <source>alarm history</source>
        <translation>Alarmhistorie</translation>
    </message>
    <message>
        <source>class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>Einzelheit</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>nicht eingegeben</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>measured load</source>
        <translation>gemessene Last</translation>
    </message>
    <message>
        <source>base coordinates</source>
        <translation>Basiskoordinaten</translation>
    </message>
    <message>
        <source>robot coordinates</source>
        <translation>Roboterkoordinaten</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>Benutzerkoordinatensystem %1</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>unbenutzt</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>weight kg</source>
        <translation>Gewicht kg</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>user frames</source>
        <translation>Benutzerkoordinatensysteme</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>interference areas</source>
        <translation>Interferenzbereiche</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>Koordinaten</translation>
    </message>
    <message>
        <source>lower X mm</source>
        <translation>X unten mm</translation>
    </message>
    <message>
        <source>upper X mm</source>
        <translation>X oben mm</translation>
    </message>
    <message>
        <source>lower Y mm</source>
        <translation>Y unten mm</translation>
    </message>
    <message>
        <source>upper Y mm</source>
        <translation>Y oben mm</translation>
    </message>
    <message>
        <source>lower Z mm</source>
        <translation>Z unten mm</translation>
    </message>
    <message>
        <source>upper Z mm</source>
        <translation>Z oben mm</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>nicht gesetzt</translation>
    </message>
    <message>
        <source>variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>Positionen</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>Benutzerkoordinatensystem</translation>
    </message>
    <message>
        <source>form</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>register</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>timer</source>
        <translation>Timer</translation>
    </message>
    <message>
        <source>home positions, pulses</source>
        <translation>Home-Positionen, Impulse</translation>
    </message>
    <message>
        <source>pseudo inputs</source>
        <translation>Pseudoeingänge</translation>
    </message>
    <message>
        <source>byte</source>
        <translation>Byte</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>Bits</translation>
    </message>
    <message>
        <source>The value of %1 could not be read.</source>
        <translation>Der Wert von %1 konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file announces %1 variables %2 and has %3; the others are not known.</source>
        <translation>Die Datei kündigt %1 Variablen %2 an und hat %3; die anderen sind nicht bekannt.</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>tool coordinates</source>
        <translation>Werkzeugkoordinaten</translation>
    </message>
    <message>
        <source>user coordinates</source>
        <translation>Benutzerkoordinaten</translation>
    </message>
    <message>
        <source>master tool coordinates</source>
        <translation>Master-Werkzeugkoordinaten</translation>
    </message>
</context>
<context>
    <name>dialogs::AccessSettingsDialog</name>
    <message>
        <source>Passcode and idle time</source>
        <translation>Kennwort und Ruhezeit</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Back to Monitor after</source>
        <translation>Zurück zu Beobachten nach</translation>
    </message>
    <message>
        <source>New passcode</source>
        <translation>Neues Kennwort</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>Noch einmal dasselbe</translation>
    </message>
    <message>
        <source>Leave both empty for no passcode.</source>
        <translation>Für kein Kennwort beide leer lassen.</translation>
    </message>
    <message>
        <source>The two are not the same.</source>
        <translation>Die beiden stimmen nicht überein.</translation>
    </message>
</context>
<context>
    <name>dialogs::AppearanceDialog</name>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Language and look</source>
        <translation>Sprache und Aussehen</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>A&amp;ussehen</translation>
    </message>
    <message>
        <source>Words of the robot and text from the controller stay as they are on the pendant.</source>
        <translation>Wörter des Roboters und Text aus der Steuerung bleiben so, wie sie auf dem Programmierhandgerät stehen.</translation>
    </message>
</context>
<context>
    <name>dialogs::ApplyDialog</name>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>Alter Wert</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Neuer Wert</translation>
    </message>
    <message>
        <source>Apply — %1</source>
        <translation>Anwenden — %1</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Was geschrieben wird</translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>%n Wert schreiben</numerusform>
            <numerusform>%n Werte schreiben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>%n Wert nach %1 schreiben</numerusform>
            <numerusform>%n Werte nach %1 schreiben</numerusform>
        </translation>
    </message>
    <message>
        <source>Each is written once and read back. What does not read back as it was written stays here and is marked.</source>
        <translation>Jeder Wert wird einmal geschrieben und zurückgelesen. Was nicht wie geschrieben zurückkommt, bleibt hier stehen und wird markiert.</translation>
    </message>
</context>
<context>
    <name>dialogs::CompareDialog</name>
    <message>
        <source>Both are the same, byte for byte.</source>
        <translation>Beide sind gleich, Byte für Byte.</translation>
    </message>
</context>
<context>
    <name>dialogs::ConnectionDialog</name>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Connect to a controller</source>
        <translation>Mit einer Steuerung verbinden</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Known controllers</source>
        <translation>Bekannte Steuerungen</translation>
    </message>
    <message>
        <source>CONTROLLERS</source>
        <translation>STEUERUNGEN</translation>
    </message>
    <message>
        <source>Connecting only reads. HOLD: Pause key.</source>
        <translation>Beim Verbinden wird nur gelesen. HOLD: Pause-Taste.</translation>
    </message>
    <message>
        <source>There is another controller with the name “%1”.</source>
        <translation>Es gibt schon eine andere Steuerung mit dem Namen „%1“.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>New controller</source>
        <translation>Neue Steuerung</translation>
    </message>
    <message>
        <source>A motion limit must be a number above 0, and each side of the box must begin before it ends.</source>
        <translation>Eine Bewegungsgrenze muss eine Zahl über 0 sein, und jede Seite des Grenzquaders muss beginnen, bevor sie endet.</translation>
    </message>
</context>
<context>
    <name>dialogs::DiagnosisDialog</name>
    <message>
        <source>Diagnosis — %1</source>
        <translation>Diagnose — %1</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>Diagnose kopieren</translation>
    </message>
    <message>
        <source>The diagnosis is not finished yet.</source>
        <translation>Die Diagnose ist noch nicht fertig.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>It only reads. HOLD works meanwhile: Pause key.</source>
        <translation>Sie liest nur. HOLD bleibt dabei möglich: Pause-Taste.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
</context>
<context>
    <name>dialogs::HelpDialog</name>
    <message>
        <source>Help — %1</source>
        <translation>Hilfe — %1</translation>
    </message>
    <message>
        <source>Search in this help</source>
        <translation>In dieser Hilfe suchen</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Hier kommen diese Wörter nicht vor.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Keys of this page</source>
        <translation>Tasten dieser Seite</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>Tasten auf allen Seiten</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Without a connection: connect to the controller on the filled button</source>
        <translation>Ohne Verbindung: mit der Steuerung auf der farbig gefüllten Schaltfläche verbinden</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Live: read within its last three turns.</source>
        <translation>Live: innerhalb der letzten drei Lesedurchgänge dieses Werts gelesen.</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.</source>
        <translation>Veraltet: einmal gelesen, aber vor zu langer Zeit. Der Tooltip sagt, wann. Es ist nicht, was der Roboter jetzt tut.</translation>
    </message>
    <message>
        <source>Unknown: not read on this connection. It is never shown as 0.</source>
        <translation>Unbekannt: in dieser Verbindung nicht gelesen. Es wird nie als 0 gezeigt.</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Refused: the controller does not tell it. The reason stands on the card or in the tool tip.</source>
        <translation>Abgelehnt: Die Steuerung nennt es nicht. Der Grund steht auf der Karte oder im Tooltip.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>A filled square: on, or 1.</source>
        <translation>Ein gefülltes Quadrat: ein, oder 1.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>A hollow square: off, or 0.</source>
        <translation>Ein leeres Quadrat: aus, oder 0.</translation>
    </message>
    <message>
        <source>held</source>
        <translation>gehalten</translation>
    </message>
    <message>
        <source>An amber triangle: error, hold, something not allowed or to be looked at.</source>
        <translation>Ein bernsteinfarbenes Dreieck: Fehler, HOLD, etwas nicht Erlaubtes oder zu Prüfendes.</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>A red square: an alarm.</source>
        <translation>Ein rotes Quadrat: ein Alarm.</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>Was die Zeichen bedeuten</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>An amber ground in a table: typed and staged, not sent yet. A red one: it reads back differently from what was written.</source>
        <translation>Ein bernsteinfarbener Grund in einer Tabelle: eingegeben und vorgemerkt, noch nicht gesendet. Ein roter: Der Wert wird anders zurückgelesen, als er geschrieben wurde.</translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message>
        <source>Take over values — %1</source>
        <translation>Werte übernehmen — %1</translation>
    </message>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>%n Wert vormerken</numerusform>
            <numerusform>%n Werte vormerken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>%n Wert würde sich ändern</numerusform>
            <numerusform>%n Werte würden sich ändern</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>%n Wert ist bereits so vorhanden. Beim Vormerken wird nichts an die Steuerung gesendet.</numerusform>
            <numerusform>%n Werte sind bereits so vorhanden. Beim Vormerken wird nichts an die Steuerung gesendet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n Zeile ist nicht lesbar, deshalb wird nichts übernommen:</numerusform>
            <numerusform>%n Zeilen sind nicht lesbar, deshalb wird nichts übernommen:</numerusform>
        </translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>Alter Wert</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Neuer Wert</translation>
    </message>
    <message>
        <source>Lines that cannot be read</source>
        <translation>Nicht lesbare Zeilen</translation>
    </message>
    <message>
        <source>Values that would change</source>
        <translation>Werte, die sich ändern würden</translation>
    </message>
</context>
<context>
    <name>dialogs::IoWriteDialog</name>
    <message>
        <source>Write %1 — %2</source>
        <translation>%1 schreiben — %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>Künftig</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The eight signals #%1 to #%2 travel together: all of them are written as they stand here.</source>
        <translation>Die acht Signale #%1 bis #%2 werden zusammen übertragen: Alle werden so geschrieben, wie sie hier stehen.</translation>
    </message>
    <message>
        <source>The group is being read…</source>
        <translation>Die Gruppe wird gelesen…</translation>
    </message>
    <message>
        <source>Written once, then read back.</source>
        <translation>Einmal geschrieben, dann zurückgelesen.</translation>
    </message>
    <message>
        <source>Another of the eight has changed meanwhile. Nothing was sent: look again.</source>
        <translation>Ein anderes der acht Signale hat sich inzwischen geändert. Es wurde nichts gesendet: bitte erneut prüfen.</translation>
    </message>
    <message>
        <source>Being written…</source>
        <translation>Wird geschrieben…</translation>
    </message>
    <message>
        <source>Written, and read back as it was written.</source>
        <translation>Geschrieben und wie geschrieben zurückgelesen.</translation>
    </message>
    <message>
        <source>Accepted, but another value was read back: %1. Something else writes these signals.</source>
        <translation>Angenommen, aber ein anderer Wert wurde zurückgelesen: %1. Etwas anderes schreibt diese Signale.</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
</context>
<context>
    <name>dialogs::JobEditor</name>
    <message>
        <source>Edit “%1”</source>
        <translation>„%1“ bearbeiten</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>Text der Datei</translation>
    </message>
    <message>
        <source>Compare and send…</source>
        <translation>Vergleichen und senden…</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding lacks a character of this text.</source>
        <translation>Der Kodierung der Steuerung fehlt ein Zeichen dieses Textes.</translation>
    </message>
</context>
<context>
    <name>dialogs::LadderView</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Pendesk %1, diagnosis of %2 (%3)</source>
        <translation>Pendesk %1, Diagnose von %2 (%3)</translation>
    </message>
</context>
<context>
    <name>dialogs::MotionForm</name>
    <message>
        <source>The tool point must stay in this box (base frame, mm)</source>
        <translation>Der Werkzeugpunkt muss in diesem Grenzquader bleiben (Basiskoordinatensystem, mm)</translation>
    </message>
    <message>
        <source>User and tool frames were checked on this robot</source>
        <translation>Benutzer- und Werkzeugkoordinatensystem wurden an diesem Roboter geprüft</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>Geschwindigkeit, mm/s</translation>
    </message>
    <message>
        <source>Rotation speed, °/s</source>
        <translation>Drehgeschwindigkeit, °/s</translation>
    </message>
    <message>
        <source>Joint speed, %</source>
        <translation>Achsgeschwindigkeit, %</translation>
    </message>
    <message>
        <source>Jog step, mm</source>
        <translation>Schritt im Tippbetrieb, mm</translation>
    </message>
    <message>
        <source>Jog step, °</source>
        <translation>Schritt im Tippbetrieb, °</translation>
    </message>
    <message>
        <source>Jog step, pulses</source>
        <translation>Schritt im Tippbetrieb, Impulse</translation>
    </message>
    <message>
        <source>Descriptions disagree which code means the user and which the tool frame. Tick this only after a small move in both was watched at the robot.</source>
        <translation>Die Beschreibungen sind sich nicht einig, welcher Code das Benutzer- und welcher das Werkzeugkoordinatensystem bedeutet. Haken Sie dies erst ab, nachdem am Roboter eine kleine Bewegung in beiden beobachtet wurde.</translation>
    </message>
    <message>
        <source>%1, as the program</source>
        <translation>%1, Vorgabe des Programms</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>Kleinstes %1</translation>
    </message>
    <message>
        <source>Most %1</source>
        <translation>Größtes %1</translation>
    </message>
    <message>
        <source>%1 from, to</source>
        <translation>%1 von, bis</translation>
    </message>
</context>
<context>
    <name>dialogs::MoveSheet</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 Impulse</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Stop: HOLD</source>
        <translation>Stopp: HOLD</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Move at %1</source>
        <translation>Bewegen an %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>Achsgruppe</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Grenzquader</translation>
    </message>
    <message>
        <source>Stored points near the target</source>
        <translation>Gespeicherte Punkte nahe am Ziel</translation>
    </message>
    <message>
        <source>A long move, or one that nobody can measure: type %1</source>
        <translation>Eine lange oder nicht messbare Bewegung: %1 eingeben</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>Mit der Tastatur: %1 eingeben, dann F9</translation>
    </message>
    <message>
        <source>HOLD stays on until it is released</source>
        <translation>HOLD bleibt eingeschaltet, bis es aufgehoben wird</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>Der Roboter wird sich bewegen</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>cannot be foretold in this frame</source>
        <translation>in diesem Koordinatensystem nicht vorhersagbar</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>etwa %1 s</translation>
    </message>
    <message>
        <source>not known: a percentage of joint speed</source>
        <translation>nicht bekannt: Prozentsatz der Achsgeschwindigkeit</translation>
    </message>
    <message>
        <source>not known: the target is in pulses</source>
        <translation>nicht bekannt: Das Ziel ist in Impulsen angegeben</translation>
    </message>
    <message>
        <source>%1 mm and %2° between the ends; a joint move does not go straight</source>
        <translation>%1 mm und %2° zwischen Anfang und Ende; eine Achsbewegung verläuft nicht geradlinig</translation>
    </message>
    <message>
        <source>%1 mm straight, turning %2°</source>
        <translation>%1 mm geradlinig, Drehung um %2°</translation>
    </message>
    <message>
        <source>none is set for this controller</source>
        <translation>für diese Steuerung ist keiner festgelegt</translation>
    </message>
    <message>
        <source>the whole way is inside</source>
        <translation>der ganze Weg liegt innerhalb</translation>
    </message>
    <message>
        <source>both ends are inside; the way between is not known</source>
        <translation>Anfang und Ende liegen innerhalb; der Weg dazwischen ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1, at most %2 %</source>
        <translation>%1, höchstens %2 %</translation>
    </message>
    <message>
        <source>%1, at most %2 mm/s</source>
        <translation>%1, höchstens %2 mm/s</translation>
    </message>
    <message>
        <source>%1, at most %2 °/s</source>
        <translation>%1, höchstens %2 °/s</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>nicht vergleichbar</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 in %2 mm Abstand</translation>
    </message>
    <message>
        <source>none in the base frame was read</source>
        <translation>keiner im Basiskoordinatensystem gelesen</translation>
    </message>
    <message>
        <source>The robot is no longer where this move begins: close, and rehearse again.</source>
        <translation>Der Roboter steht nicht mehr dort, wo diese Bewegung beginnt: Schließen Sie, und prüfen Sie erneut vorab.</translation>
    </message>
    <message>
        <source>Not sent: the place could not be read.</source>
        <translation>Nicht gesendet: Die Position konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>a place that was not read</source>
        <translation>einer nicht gelesenen Position</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>In Bewegung: %1</translation>
    </message>
    <message>
        <source>Move sent…</source>
        <translation>Bewegung gesendet…</translation>
    </message>
    <message>
        <source>Arrived: %1</source>
        <translation>Angekommen: %1</translation>
    </message>
    <message>
        <source>Stopped at %1. That is not the target.</source>
        <translation>Angehalten bei %1. Das ist nicht das Ziel.</translation>
    </message>
    <message>
        <source>At rest at %1. Whether that is the target cannot be told in this frame.</source>
        <translation>In Ruhe bei %1. Ob das das Ziel ist, lässt sich in diesem Koordinatensystem nicht sagen.</translation>
    </message>
    <message>
        <source>No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.</source>
        <translation>Keine Antwort auf die Bewegung: Ob sie begonnen wurde, ist unbekannt. Sie wurde einmal gesendet. Sehen Sie nach dem Roboter.</translation>
    </message>
    <message>
        <source>The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.</source>
        <translation>Der Ausgang ist unbekannt: Die Kommunikation ging verloren, oder der Roboter kommt nicht zur Ruhe. Sehen Sie nach dem Roboter.</translation>
    </message>
</context>
<context>
    <name>dialogs::NumberingDialog</name>
    <message>
        <source>Variable numbering — %1</source>
        <translation>Variablennummerierung — %1</translation>
    </message>
    <message>
        <source>Number of the variable</source>
        <translation>Nummer der Variablen</translation>
    </message>
    <message>
        <source>Value on the pendant</source>
        <translation>Wert auf dem Programmierhandgerät</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>reads on the pendant</source>
        <translation>hat auf dem Programmierhandgerät</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>Ergebnis behalten</translation>
    </message>
    <message>
        <source>Which number is which?</source>
        <translation>Welche Nummer ist welche?</translation>
    </message>
    <message>
        <source>Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) and enter what you see. This test only reads.</source>
        <translation>Der Parameter RS022 legt fest, ob B000 im Netzwerk die Nummer 0 oder 1 hat. Solange das nicht bekannt ist, könnte ein Schreibvorgang die Nachbarvariable treffen; deshalb wird keiner gesendet. Lesen Sie zwei Variablen auf dem Programmierhandgerät ab (Hauptmenü, VARIABLE, BYTE) und geben Sie ein, was Sie sehen. Dieser Test liest nur.</translation>
    </message>
    <message>
        <source>The variables could not be read: %1.</source>
        <translation>Die Variablen konnten nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 and B011 to 2, then open this test again.</source>
        <translation>Alle B-Variablen haben denselben Wert, das beweist nichts: Setzen Sie B010 durch einen Job oder am Programmierhandgerät auf 1 und B011 auf 2, und öffnen Sie diesen Test dann erneut.</translation>
    </message>
    <message>
        <source>These two tell the numberings apart.</source>
        <translation>Mit diesen beiden lassen sich die Nummerierungen unterscheiden.</translation>
    </message>
    <message>
        <source>Verified: number 0 on the network is B000.</source>
        <translation>Geprüft: Nummer 0 im Netzwerk ist B000.</translation>
    </message>
    <message>
        <source>Verified, shifted: number 1 on the network is B000.</source>
        <translation>Geprüft, verschoben: Nummer 1 im Netzwerk ist B000.</translation>
    </message>
    <message>
        <source>Both numberings fit these values: choose variables whose neighbours hold other values.</source>
        <translation>Beide Nummerierungen passen zu diesen Werten: Wählen Sie Variablen, deren Nachbarn andere Werte haben.</translation>
    </message>
    <message>
        <source>Neither numbering fits: read the values again, they may have changed.</source>
        <translation>Keine der Nummerierungen passt: Lesen Sie die Werte erneut ab, sie haben sich vielleicht geändert.</translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>Auch für die verbleibende %n Datei</numerusform>
            <numerusform>Auch für die verbleibenden %n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” exists</source>
        <translation>„%1“ ist vorhanden</translation>
    </message>
    <message>
        <source>There is a file “%1” %2 already.</source>
        <translation>Es gibt %2 schon eine Datei „%1“.</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>&amp;Vergleichen…</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>&amp;Keep both</source>
        <translation>&amp;Beide behalten</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>Ü&amp;berspringen</translation>
    </message>
</context>
<context>
    <name>dialogs::PasscodeDialog</name>
    <message>
        <source>The passcode guards against mistakes, not against attackers: whoever can change this user&apos;s files can remove it.</source>
        <translation>Das Kennwort schützt vor Versehen, nicht vor Angriffen: Wer die Dateien dieses Benutzers ändern kann, kann es entfernen.</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>Zugriffsstufe: %1</translation>
    </message>
    <message>
        <source>Passcode</source>
        <translation>Kennwort</translation>
    </message>
    <message>
        <source>That is not the passcode.</source>
        <translation>Das ist nicht das Kennwort.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Wird geprüft…</translation>
    </message>
</context>
<context>
    <name>dialogs::PositionDialog</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Vormerken</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>Benutzerkoordinatensystem</translation>
    </message>
    <message>
        <source>Take the present position of R1 (base frame)</source>
        <translation>Aktuelle Position von R1 übernehmen (Basiskoordinatensystem)</translation>
    </message>
    <message>
        <source>Take R1 in pulses</source>
        <translation>R1 in Impulsen übernehmen</translation>
    </message>
    <message>
        <source>Take the present position of B1 (base frame)</source>
        <translation>Aktuelle Position von B1 übernehmen (Basiskoordinatensystem)</translation>
    </message>
    <message>
        <source>Take B1 in pulses</source>
        <translation>B1 in Impulsen übernehmen</translation>
    </message>
    <message>
        <source>Take the present position of S1</source>
        <translation>Aktuelle Position von S1 übernehmen</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>live: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A user-frame position needs a user frame from 1 to 63.</source>
        <translation>Eine Position im Benutzerkoordinatensystem braucht ein Benutzerkoordinatensystem von 1 bis 63.</translation>
    </message>
    <message>
        <source>Sources disagree which code means user and which means tool frame: check on the pendant before a job uses this position.</source>
        <translation>Die Quellen sind sich nicht einig, welcher Code das Benutzer- und welcher das Werkzeugkoordinatensystem bedeutet: Auf dem Programmierhandgerät prüfen, bevor ein Job diese Position benutzt.</translation>
    </message>
    <message>
        <source>The position is being read…</source>
        <translation>Die Position wird gelesen…</translation>
    </message>
    <message>
        <source>The position could not be read: %1.</source>
        <translation>Die Position konnte nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>Erweiterte Stellung</translation>
    </message>
</context>
<context>
    <name>dialogs::ProfileForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Host name or address</source>
        <translation>Hostname oder Adresse</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Text encoding</source>
        <translation>Textkodierung</translation>
    </message>
    <message>
        <source>Variable numbering</source>
        <translation>Variablennummerierung</translation>
    </message>
    <message>
        <source>B000 is number 0 on the wire</source>
        <translation>B000 hat im Netzwerk die Nummer 0</translation>
    </message>
    <message>
        <source>B000 is number 1 on the wire</source>
        <translation>B000 hat im Netzwerk die Nummer 1</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Dateiport</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>Zeitlimit Lesen</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>Zeitlimit Dateien</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>Zeitlimit Servo</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>Wiederholungen beim Lesen</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>Gleichzeitig offene Anfragen</translation>
    </message>
    <message>
        <source>Requests a second, at most</source>
        <translation>Anfragen pro Sekunde, höchstens</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
    <message>
        <source>Jog and move, at most</source>
        <translation>Tippbetrieb und Bewegen, höchstens</translation>
    </message>
</context>
<context>
    <name>dialogs::ReadinessSheet</name>
    <message>
        <source>Readiness — %1</source>
        <translation>Bereitschaft — %1</translation>
    </message>
    <message>
        <source>What %1 allows now</source>
        <translation>Was %1 jetzt erlaubt</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Bereitschaft</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the readiness and a diagnosis</source>
        <translation>Bereitschaft und eine Diagnose kopieren</translation>
    </message>
    <message>
        <source>As text for support, with a diagnosis of the link, which takes a moment.</source>
        <translation>Als Text für den Support, mit einer Diagnose der Verbindung, die einen Moment dauert.</translation>
    </message>
    <message>
        <source>Test numbering…</source>
        <translation>Nummerierung testen…</translation>
    </message>
    <message>
        <source>It needs a link to the controller.</source>
        <translation>Dazu muss eine Verbindung zur Steuerung bestehen.</translation>
    </message>
    <message>
        <source>Communication lost at %1: what is hatched was read before.</source>
        <translation>Kommunikation um %1 verloren: Was schraffiert ist, wurde davor gelesen.</translation>
    </message>
    <message>
        <source>%1 has not answered yet.</source>
        <translation>%1 hat noch nicht geantwortet.</translation>
    </message>
    <message>
        <source>Not connected: nothing is read.</source>
        <translation>Nicht verbunden: Es wird nichts gelesen.</translation>
    </message>
    <message>
        <source>The status was not read just now.</source>
        <translation>Der Status ist nicht aktuell.</translation>
    </message>
    <message>
        <source>It is read live and changes nothing. HOLD works meanwhile: Pause key.</source>
        <translation>Es wird live gelesen und nichts geändert. HOLD bleibt dabei möglich: Pause-Taste.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message>
        <source>Put that file back</source>
        <translation>Diese Datei zurückstellen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Restore %1 from %2</source>
        <translation>%1 aus %2 zurückspielen</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>Was geschehen würde</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>Was geschieht</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>+ new: it is sent</source>
        <translation>+ neu: wird gesendet</translation>
    </message>
    <message>
        <source>≠ changed: it is replaced</source>
        <translation>≠ geändert: wird ersetzt</translation>
    </message>
    <message>
        <source>= same: left alone</source>
        <translation>= gleich: bleibt unberührt</translation>
    </message>
    <message>
        <source>▲ not allowed: left alone</source>
        <translation>▲ nicht erlaubt: bleibt unberührt</translation>
    </message>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>Sichern, dann %n Datei zurückspielen</numerusform>
            <numerusform>Sichern, dann %n Dateien zurückspielen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>%n Datei ist gleich und nicht aufgeführt.</numerusform>
            <numerusform>%n Dateien sind gleich und nicht aufgeführt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Sending file %1 of %2…</source>
        <translation>Datei %1 von %2 wird gesendet…</translation>
    </message>
    <message>
        <source>Fresh backup: file %1 of %2…</source>
        <translation>Frische Sicherung: Datei %1 von %2…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>%n Datei wurde zurückgespielt und zurückgelesen.</numerusform>
            <numerusform>%n Dateien wurden zurückgespielt und zurückgelesen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>%n Datei wurde davor zurückgespielt.</numerusform>
            <numerusform>%n Dateien wurden davor zurückgespielt.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>Es wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Stopped at %1.</source>
        <translation>Angehalten bei %1.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>Es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>The file is as it was before.</source>
        <translation>Die Datei ist wie zuvor.</translation>
    </message>
    <message>
        <source>▲ The file could not be put back. Look at the controller.</source>
        <translation>▲ Die Datei konnte nicht zurückgestellt werden. Sehen Sie an der Steuerung nach.</translation>
    </message>
    <message>
        <source>A fresh backup of %1 is made first. Then the files below are sent one by one and read back. A refused file is left out; it stops at any other error.</source>
        <translation>Zuerst wird eine frische Sicherung von %1 gemacht. Dann werden die Dateien unten einzeln gesendet und zurückgelesen. Eine abgelehnte Datei wird ausgelassen; bei jedem anderen Fehler wird angehalten.</translation>
    </message>
    <message>
        <source>%1: the backup is of %2, the controller is %3.</source>
        <translation>%1: Die Sicherung ist von %2, die Steuerung ist %3.</translation>
    </message>
    <message>
        <source>This is the backup of another robot: nothing of it is sent.</source>
        <translation>Das ist die Sicherung eines anderen Roboters: Nichts davon wird gesendet.</translation>
    </message>
    <message>
        <source>The controller refused %1; the other files were sent.</source>
        <translation>Die Steuerung hat %1 abgelehnt; die anderen Dateien wurden gesendet.</translation>
    </message>
</context>
<context>
    <name>dialogs::SignalPicker</name>
    <message>
        <source>Add a signal</source>
        <translation>Signal hinzufügen</translation>
    </message>
    <message>
        <source>For example: R1 torque, B005, #00010, M012</source>
        <translation>Zum Beispiel: R1 Drehmoment, B005, #00010, M012</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>dialogs::StartSheet</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Start at %1</source>
        <translation>Start an %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>Ab Zeile</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Geschwindigkeits-Override</translation>
    </message>
    <message>
        <source>HOLD: Pause key</source>
        <translation>HOLD: Pause-Taste</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>Der Roboter wird sich bewegen</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>Mit der Tastatur: %1 eingeben, dann F9</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Start sent…</source>
        <translation>Start gesendet…</translation>
    </message>
    <message>
        <source>Accepted. Waiting for RUN…</source>
        <translation>Angenommen. Warten auf RUN…</translation>
    </message>
    <message>
        <source>The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.</source>
        <translation>Der Start wurde angenommen, aber 3 s lang war kein RUN zu sehen. Übliche Ursachen: Der Job war so kurz, dass er schon beendet ist, er wartet auf eine Bedingung der Zelle, oder das Programmierhandgerät zeigt eine Rückfrage. Sehen Sie auf das Programmierhandgerät.</translation>
    </message>
    <message>
        <source>No answer to the start: it may or may not have happened. Reading the status…</source>
        <translation>Keine Antwort auf den Start: Er kann ausgeführt worden sein oder auch nicht. Der Status wird gelesen…</translation>
    </message>
    <message>
        <source>No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.</source>
        <translation>Keine Antwort auf den Start und keine auf die Statusabfrage: Ob der Roboter läuft, ist unbekannt. Sehen Sie nach ihm.</translation>
    </message>
    <message>
        <source>No answer to the start, but a status that was read afterwards said RUN. It was sent once.</source>
        <translation>Keine Antwort auf den Start, aber ein danach gelesener Status meldete RUN. Er wurde einmal gesendet.</translation>
    </message>
    <message>
        <source>No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you start again.</source>
        <translation>Keine Antwort auf den Start, und ein danach gelesener Status meldete kein RUN. Sehen Sie nach dem Roboter, bevor Sie noch einmal starten.</translation>
    </message>
</context>
<context>
    <name>dialogs::WhyNotDialog</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>What must be the case</source>
        <translation>Was erfüllt sein muss</translation>
    </message>
</context>
<context>
    <name>files::Identity</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Robots and axes</source>
        <translation>Roboter und Achsen</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Number of variables</source>
        <translation>Anzahl der Variablen</translation>
    </message>
</context>
<context>
    <name>files::Restore</name>
    <message>
        <source>It is not in the backup.</source>
        <translation>Sie ist nicht in der Sicherung.</translation>
    </message>
    <message>
        <source>What the controller has could not be read.</source>
        <translation>Was die Steuerung enthält, konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>In the backup it is not as it was written.</source>
        <translation>In der Sicherung ist sie nicht so, wie sie geschrieben wurde.</translation>
    </message>
    <message>
        <source>It belongs to this one controller, or only tells what happened: it is never sent.</source>
        <translation>Sie gehört zu dieser einen Steuerung oder sagt nur, was geschehen ist: Sie wird nie gesendet.</translation>
    </message>
    <message>
        <source>It comes from another robot.</source>
        <translation>Sie stammt von einem anderen Roboter.</translation>
    </message>
    <message>
        <source>It changes how the robot moves, or what protects people: look at the differences and choose it.</source>
        <translation>Sie ändert, wie sich der Roboter bewegt oder was Menschen schützt: Sehen Sie sich die Unterschiede an, und wählen Sie sie.</translation>
    </message>
</context>
<context>
    <name>files::Verify</name>
    <message>
        <source>This is no backup: %1 is missing or of another kind.</source>
        <translation>Das ist keine Sicherung: %1 fehlt oder ist von anderer Art.</translation>
    </message>
    <message>
        <source>%1 is not as it was written.</source>
        <translation>%1 ist nicht so, wie es geschrieben wurde.</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 fehlt.</translation>
    </message>
    <message>
        <source>%1 does not belong to the backup.</source>
        <translation>%1 gehört nicht zur Sicherung.</translation>
    </message>
</context>
<context>
    <name>inform::Check</name>
    <message>
        <source>The file is empty.</source>
        <translation>Die Datei ist leer.</translation>
    </message>
    <message>
        <source>HSES cannot carry it.</source>
        <translation>HSES kann sie nicht übertragen.</translation>
    </message>
    <message>
        <source>“%1” is no type of file that can be sent.</source>
        <translation>„%1“ ist kein Dateityp, der gesendet werden kann.</translation>
    </message>
    <message>
        <source>Controllers take JBI, JBR, CND, DAT, PRM and LST.</source>
        <translation>Steuerungen nehmen JBI, JBR, CND, DAT, PRM und LST an.</translation>
    </message>
    <message>
        <source>The type of the file is written in small letters.</source>
        <translation>Der Dateityp ist in Kleinbuchstaben geschrieben.</translation>
    </message>
    <message>
        <source>Controllers write it in capitals.</source>
        <translation>Steuerungen schreiben ihn in Großbuchstaben.</translation>
    </message>
    <message>
        <source>The header names the job “%1”.</source>
        <translation>Der Kopf nennt den Job „%1“.</translation>
    </message>
    <message>
        <source>The name in the header counts: that job would be written.</source>
        <translation>Der Name im Kopf zählt: Jener Job würde geschrieben.</translation>
    </message>
    <message>
        <source>The job is being executed.</source>
        <translation>Der Job wird gerade ausgeführt.</translation>
    </message>
    <message>
        <source>A running job cannot be replaced.</source>
        <translation>Ein laufender Job kann nicht ersetzt werden.</translation>
    </message>
    <message>
        <source>All names in the controller become those in this file.</source>
        <translation>Alle Namen in der Steuerung werden zu denen in dieser Datei.</translation>
    </message>
    <message>
        <source>Back them up first.</source>
        <translation>Sichern Sie sie zuerst.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark.</source>
        <translation>Die Datei beginnt mit einer Byte-Reihenfolge-Marke (BOM).</translation>
    </message>
    <message>
        <source>Controllers know no such mark: save the file without it.</source>
        <translation>Steuerungen kennen diese Marke nicht: Speichern Sie die Datei ohne sie.</translation>
    </message>
    <message>
        <source>The file is UTF-16 text.</source>
        <translation>Die Datei ist UTF-16-Text.</translation>
    </message>
    <message>
        <source>Controllers take one byte for a letter.</source>
        <translation>Steuerungen nehmen ein Byte pro Buchstabe.</translation>
    </message>
    <message>
        <source>The lines end in CR alone.</source>
        <translation>Die Zeilen enden nur mit CR.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).</source>
        <translation>Zeilen enden mit CR LF; die Steuerung findet weder NOP noch END (Handgerät 3200).</translation>
    </message>
    <message>
        <source>Lines end in LF alone.</source>
        <translation>Die Zeilen enden nur mit LF.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).</source>
        <translation>Zeilen enden mit CR LF; die Steuerung findet weder NOP noch END (0x5130, Handgerät 3200).</translation>
    </message>
    <message>
        <source>Lines end in CR LF; a controller may read such a file as empty.</source>
        <translation>Zeilen enden mit CR LF; eine Steuerung kann eine solche Datei als leer lesen.</translation>
    </message>
    <message>
        <source>The last line does not end.</source>
        <translation>Die letzte Zeile hat kein Zeilenende.</translation>
    </message>
    <message>
        <source>Controllers end each line in CR LF.</source>
        <translation>Steuerungen beenden jede Zeile mit CR LF.</translation>
    </message>
    <message>
        <source>There is a Ctrl-Z at the end.</source>
        <translation>Am Ende steht ein Ctrl-Z.</translation>
    </message>
    <message>
        <source>It stands behind END, which must be last (0x5130).</source>
        <translation>Es steht hinter END, das zuletzt stehen muss (0x5130).</translation>
    </message>
    <message>
        <source>There is a control character.</source>
        <translation>Es gibt ein Steuerzeichen.</translation>
    </message>
    <message>
        <source>No line of a job may have one.</source>
        <translation>Keine Zeile eines Jobs darf eines haben.</translation>
    </message>
    <message>
        <source>This is no job: it does not have the line /JOB.</source>
        <translation>Das ist kein Job: Die Zeile /JOB fehlt.</translation>
    </message>
    <message>
        <source>A job begins with it (0x5310).</source>
        <translation>Ein Job beginnt mit ihr (0x5310).</translation>
    </message>
    <message>
        <source>The file holds more than one job.</source>
        <translation>Die Datei enthält mehr als einen Job.</translation>
    </message>
    <message>
        <source>Only the first one was looked at.</source>
        <translation>Nur der erste wurde geprüft.</translation>
    </message>
    <message>
        <source>“%1” is no name for a job.</source>
        <translation>„%1“ ist kein Name für einen Job.</translation>
    </message>
    <message>
        <source>A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).</source>
        <translation>Ein Name hat 1 bis 32 Bytes, keine Leerzeichen und keines der Zeichen, die Dateinamen nicht haben dürfen (0x4190).</translation>
    </message>
    <message>
        <source>There is text that belongs to no section.</source>
        <translation>Es gibt Text, der zu keinem Abschnitt gehört.</translation>
    </message>
    <message>
        <source>It is no INFORM (0x5310).</source>
        <translation>Es ist kein INFORM (0x5310).</translation>
    </message>
    <message>
        <source>%1 is no known pseudo instruction.</source>
        <translation>%1 ist keine bekannte Pseudoanweisung.</translation>
    </message>
    <message>
        <source>A controller that does not know it refuses the file (0x5340).</source>
        <translation>Eine Steuerung, die sie nicht kennt, lehnt die Datei ab (0x5340).</translation>
    </message>
    <message>
        <source>The comment of the job is longer than 32 bytes.</source>
        <translation>Der Kommentar des Jobs ist länger als 32 Bytes.</translation>
    </message>
    <message>
        <source>Controllers cut it or refuse it.</source>
        <translation>Steuerungen kürzen ihn oder lehnen ihn ab.</translation>
    </message>
    <message>
        <source>A frame is given, and the attribute RJ is missing.</source>
        <translation>Ein Koordinatensystem ist angegeben, und das Attribut RJ fehlt.</translation>
    </message>
    <message>
        <source>Only relative jobs have a frame (0x4490).</source>
        <translation>Nur Relativjobs haben ein Koordinatensystem (0x4490).</translation>
    </message>
    <message>
        <source>The job is relative, and no frame is given.</source>
        <translation>Der Job ist relativ, und kein Koordinatensystem ist genannt.</translation>
    </message>
    <message>
        <source>A relative job names its frame (0x3390).</source>
        <translation>Ein Relativjob nennt sein Koordinatensystem (0x3390).</translation>
    </message>
    <message>
        <source>There are positions, and no ///NPOS that counts them.</source>
        <translation>Es gibt Positionen und kein ///NPOS, das sie zählt.</translation>
    </message>
    <message>
        <source>The controller compares them (0x5180).</source>
        <translation>Die Steuerung vergleicht sie (0x5180).</translation>
    </message>
    <message>
        <source>///NPOS does not count the positions of each kind: %1 (kind, said, found).</source>
        <translation>///NPOS zählt die Positionen jeder Art nicht richtig: %1 (Art, angegeben, gefunden).</translation>
    </message>
    <message>
        <source>There is text among the positions that is none.</source>
        <translation>Zwischen den Positionen steht Text, der keine ist.</translation>
    </message>
    <message>
        <source>Every line of //POS is a position or a pseudo instruction (0x5120).</source>
        <translation>Jede Zeile von //POS ist eine Position oder eine Pseudoanweisung (0x5120).</translation>
    </message>
    <message>
        <source>%1 is there twice.</source>
        <translation>%1 ist zweimal vorhanden.</translation>
    </message>
    <message>
        <source>Each position has one entry (0x5120).</source>
        <translation>Jede Position hat einen Eintrag (0x5120).</translation>
    </message>
    <message>
        <source>%1 is named by no line.</source>
        <translation>%1 wird in keiner Zeile genannt.</translation>
    </message>
    <message>
        <source>Each taught point belongs to one instruction (pendant 3190).</source>
        <translation>Jeder geteachte Punkt gehört zu einer Anweisung (Handgerät 3190).</translation>
    </message>
    <message>
        <source>%1 has no entry among the positions.</source>
        <translation>%1 hat keinen Eintrag unter den Positionen.</translation>
    </message>
    <message>
        <source>The robot would not know where to go (0x4130).</source>
        <translation>Der Roboter wüsste nicht, wohin er fahren soll (0x4130).</translation>
    </message>
    <message>
        <source>%1 is named in two places.</source>
        <translation>%1 wird an zwei Stellen genannt.</translation>
    </message>
    <message>
        <source>Controllers give each place a point of its own.</source>
        <translation>Steuerungen geben jeder Stelle einen eigenen Punkt.</translation>
    </message>
    <message>
        <source>The number of values does not fit the axes: %1 (position, values).</source>
        <translation>Die Anzahl der Werte passt nicht zu den Achsen: %1 (Position, Werte).</translation>
    </message>
    <message>
        <source>A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).</source>
        <translation>Ein Roboter hat 6 oder 7 Achsen, eine Basisachse 1 bis 3, eine Station 1 bis 6 (0x5180).</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1 hat einen Wert, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>The controller cannot read it (0x5120).</source>
        <translation>Die Steuerung kann sie nicht lesen (0x5120).</translation>
    </message>
    <message>
        <source>The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE.</source>
        <translation>Die Zeile ///PULSE, ///RECTAN oder ///ANGLE vor %1 passt nicht zu ihrem ///POSTYPE.</translation>
    </message>
    <message>
        <source>PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).</source>
        <translation>PULSE gehört zu ///PULSE, ANGLE zu ///ANGLE, die anderen zu ///RECTAN (0x5120).</translation>
    </message>
    <message>
        <source>%1 is in pulses, and the job is relative.</source>
        <translation>%1 ist in Impulsen, und der Job ist relativ.</translation>
    </message>
    <message>
        <source>The points of a relative job stand in its frame.</source>
        <translation>Die Punkte eines Relativjobs stehen in seinem Koordinatensystem.</translation>
    </message>
    <message>
        <source>There are taught points (%1), and the job has no control group.</source>
        <translation>Es gibt geteachte Punkte (%1), und der Job hat keine Achsgruppe.</translation>
    </message>
    <message>
        <source>A job without a group cannot move (0x5430).</source>
        <translation>Ein Job ohne Gruppe kann nichts bewegen (0x5430).</translation>
    </message>
    <message>
        <source>There are %1 points, and no control group of the job has such axes.</source>
        <translation>Es gibt %1-Punkte, und keine Achsgruppe des Jobs hat solche Achsen.</translation>
    </message>
    <message>
        <source>C needs a robot, BC a base, EC a station among the groups (0x3370).</source>
        <translation>C braucht einen Roboter, BC eine Basisachse, EC eine Station unter den Gruppen (0x3370).</translation>
    </message>
    <message>
        <source>The first instruction is not NOP.</source>
        <translation>Die erste Anweisung ist nicht NOP.</translation>
    </message>
    <message>
        <source>Every job begins with NOP (0x5130, pendant 3200).</source>
        <translation>Jeder Job beginnt mit NOP (0x5130, Handgerät 3200).</translation>
    </message>
    <message>
        <source>The last instruction is not END.</source>
        <translation>Die letzte Anweisung ist nicht END.</translation>
    </message>
    <message>
        <source>Every job ends with END (0x5130, pendant 3200).</source>
        <translation>Jeder Job endet mit END (0x5130, Handgerät 3200).</translation>
    </message>
    <message>
        <source>There is an END before the last line.</source>
        <translation>Vor der letzten Zeile steht ein END.</translation>
    </message>
    <message>
        <source>What follows it is no job (0x5130).</source>
        <translation>Was darauf folgt, gehört nicht zum Job (0x5130).</translation>
    </message>
    <message>
        <source>The line begins with no instruction.</source>
        <translation>Die Zeile beginnt nicht mit einer Anweisung.</translation>
    </message>
    <message>
        <source>An instruction was cut in two: it belongs to the line before (0x5110).</source>
        <translation>Eine Anweisung wurde geteilt: Sie gehört zur Zeile davor (0x5110).</translation>
    </message>
    <message>
        <source>%1 is no instruction that this program knows.</source>
        <translation>%1 ist keine Anweisung, die dieses Programm kennt.</translation>
    </message>
    <message>
        <source>It may belong to an option; a controller without it refuses the job (0x5110).</source>
        <translation>Sie kann zu einer Option gehören; eine Steuerung ohne sie lehnt den Job ab (0x5110).</translation>
    </message>
    <message>
        <source>There are characters beyond ASCII outside of comments and texts.</source>
        <translation>Außerhalb von Kommentaren und Texten gibt es Zeichen jenseits von ASCII.</translation>
    </message>
    <message>
        <source>Instructions are ASCII.</source>
        <translation>Anweisungen sind ASCII.</translation>
    </message>
    <message>
        <source>There is an empty line among the instructions.</source>
        <translation>Zwischen den Anweisungen steht eine leere Zeile.</translation>
    </message>
    <message>
        <source>Controllers write none.</source>
        <translation>Steuerungen schreiben keine.</translation>
    </message>
    <message>
        <source>The job has more than 10,000 lines.</source>
        <translation>Der Job hat mehr als 10.000 Zeilen.</translation>
    </message>
    <message>
        <source>Controllers number lines to 9999.</source>
        <translation>Steuerungen nummerieren Zeilen bis 9999.</translation>
    </message>
    <message>
        <source>A comment or message is longer than 32 bytes.</source>
        <translation>Ein Kommentar oder eine Meldung ist länger als 32 Bytes.</translation>
    </message>
    <message>
        <source>Controllers cut it.</source>
        <translation>Steuerungen kürzen ihn.</translation>
    </message>
    <message>
        <source>The label *%1 is longer than 8 bytes.</source>
        <translation>Die Marke *%1 ist länger als 8 Bytes.</translation>
    </message>
    <message>
        <source>Labels have 1 to 8 (0x4200).</source>
        <translation>Marken haben 1 bis 8 (0x4200).</translation>
    </message>
    <message>
        <source>The label *%1 is there twice.</source>
        <translation>Die Marke *%1 ist zweimal vorhanden.</translation>
    </message>
    <message>
        <source>A jump would have two goals (0x4200).</source>
        <translation>Ein Sprung hätte zwei Ziele (0x4200).</translation>
    </message>
    <message>
        <source>There is no label *%1.</source>
        <translation>Es gibt keine Marke *%1.</translation>
    </message>
    <message>
        <source>The jump gives an alarm when it is executed.</source>
        <translation>Der Sprung löst bei seiner Ausführung einen Alarm aus.</translation>
    </message>
    <message>
        <source>%1 is not closed.</source>
        <translation>%1 ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</source>
        <translation>IFTHEN braucht ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</translation>
    </message>
    <message>
        <source>%1 stands outside of what it belongs to.</source>
        <translation>%1 steht außerhalb dessen, wozu es gehört.</translation>
    </message>
    <message>
        <source>Structures are closed in the reverse order (0x5110).</source>
        <translation>Strukturen werden in umgekehrter Reihenfolge geschlossen (0x5110).</translation>
    </message>
    <message>
        <source>Structures are nested more than 10 deep.</source>
        <translation>Strukturen sind tiefer als 10 verschachtelt.</translation>
    </message>
    <message>
        <source>Controllers allow 10.</source>
        <translation>Steuerungen erlauben 10.</translation>
    </message>
    <message>
        <source>%1 is out of range.</source>
        <translation>%1 liegt außerhalb des Bereichs.</translation>
    </message>
    <message>
        <source>The controller may refuse it (0x5200).</source>
        <translation>Die Steuerung kann es ablehnen (0x5200).</translation>
    </message>
    <message>
        <source>There are more than 8 arguments.</source>
        <translation>Es gibt mehr als 8 Argumente.</translation>
    </message>
    <message>
        <source>A job takes 8 (0x5110).</source>
        <translation>Ein Job nimmt 8 an (0x5110).</translation>
    </message>
    <message>
        <source>%1 is beyond what ///LVARS provides.</source>
        <translation>%1 liegt jenseits dessen, was ///LVARS vorsieht.</translation>
    </message>
    <message>
        <source>The job has fewer local variables (0x5110).</source>
        <translation>Der Job hat weniger lokale Variablen (0x5110).</translation>
    </message>
    <message>
        <source>Line %1 of the file, named by line %2: %3</source>
        <translation>Zeile %1 der Datei, genannt in Zeile %2: %3</translation>
    </message>
    <message>
        <source>Line %1 (%2 in the file): %3</source>
        <translation>Zeile %1 (%2 in der Datei): %3</translation>
    </message>
    <message>
        <source>Line %1 of the file: %2</source>
        <translation>Zeile %1 der Datei: %2</translation>
    </message>
    <message>
        <source>There is no ///NPOS.</source>
        <translation>Es gibt kein ///NPOS.</translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message>
        <source>arm form: field %1 of RCONF %2 → %3</source>
        <translation>Armstellung: Feld %1 von RCONF %2 → %3</translation>
    </message>
    <message>
        <source>arm form: %1 → %2</source>
        <translation>Armstellung: %1 → %2</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>%1 pulses in %2</source>
        <translation>%1 Impulse in %2</translation>
    </message>
    <message>
        <source>%1 mm in %2</source>
        <translation>%1 mm in %2</translation>
    </message>
    <message>
        <source>%1° in %2</source>
        <translation>%1° in %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>insgesamt %1</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>verschoben: %1</translation>
    </message>
    <message>
        <source>moved %1 (%2)</source>
        <translation>verschoben: %1 (%2)</translation>
    </message>
    <message>
        <source>type %1 → %2</source>
        <translation>Typ %1 → %2</translation>
    </message>
    <message>
        <source>tool %1 → %2</source>
        <translation>Werkzeug %1 → %2</translation>
    </message>
    <message>
        <source>user frame %1 → %2</source>
        <translation>Benutzerkoordinatensystem %1 → %2</translation>
    </message>
    <message>
        <source>marked as beyond the limit</source>
        <translation>als jenseits der Grenze gekennzeichnet</translation>
    </message>
    <message>
        <source>no longer marked as beyond the limit</source>
        <translation>nicht mehr als jenseits der Grenze gekennzeichnet</translation>
    </message>
    <message>
        <source>values %1 → %2</source>
        <translation>Werte %1 → %2</translation>
    </message>
    <message>
        <source>Made a relative job</source>
        <translation>Zum Relativjob gemacht</translation>
    </message>
    <message>
        <source>No longer a relative job</source>
        <translation>Kein Relativjob mehr</translation>
    </message>
    <message>
        <source>The job is locked against editing</source>
        <translation>Der Job ist gegen Bearbeitung gesperrt</translation>
    </message>
    <message>
        <source>The job is no longer locked against editing</source>
        <translation>Der Job ist nicht mehr gegen Bearbeitung gesperrt</translation>
    </message>
    <message>
        <source>Made a macro job</source>
        <translation>Zum Makrojob gemacht</translation>
    </message>
    <message>
        <source>No longer a macro job</source>
        <translation>Kein Makrojob mehr</translation>
    </message>
    <message>
        <source>Attribute %1 added</source>
        <translation>Attribut %1 hinzugefügt</translation>
    </message>
    <message>
        <source>Attribute %1 removed</source>
        <translation>Attribut %1 entfernt</translation>
    </message>
    <message>
        <source>Relative frame %1 added</source>
        <translation>Relativkoordinatensystem %1 hinzugefügt</translation>
    </message>
    <message>
        <source>Relative frame %1 removed</source>
        <translation>Relativkoordinatensystem %1 entfernt</translation>
    </message>
    <message>
        <source>Relative frame: %1 → %2</source>
        <translation>Relativkoordinatensystem: %1 → %2</translation>
    </message>
    <message>
        <source>Job name: “%1” → “%2”</source>
        <translation>Jobname: „%1“ → „%2“</translation>
    </message>
    <message>
        <source>Job folder: “%1” → “%2”</source>
        <translation>Jobordner: „%1“ → „%2“</translation>
    </message>
    <message>
        <source>Comment of the job: “%1” → “%2”</source>
        <translation>Kommentar des Jobs: „%1“ → „%2“</translation>
    </message>
    <message>
        <source>Control group GROUP%1: %2 → %3</source>
        <translation>Achsgruppe GROUP%1: %2 → %3</translation>
    </message>
    <message>
        <source>Control group GROUP%1 added: %2</source>
        <translation>Achsgruppe GROUP%1 hinzugefügt: %2</translation>
    </message>
    <message>
        <source>Control group GROUP%1 removed: %2</source>
        <translation>Achsgruppe GROUP%1 entfernt: %2</translation>
    </message>
    <message>
        <source>Local variables %1: %2 → %3</source>
        <translation>Lokale Variablen %1: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1: %2 → %3</source>
        <translation>Alias von %1: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1 added: %2</source>
        <translation>Alias von %1 hinzugefügt: %2</translation>
    </message>
    <message>
        <source>Alias of %1 removed: %2</source>
        <translation>Alias von %1 entfernt: %2</translation>
    </message>
    <message>
        <source>Argument %1: “%2” → “%3”</source>
        <translation>Argument %1: „%2“ → „%3“</translation>
    </message>
    <message>
        <source>Line %1 %2</source>
        <translation>Zeile %1 %2</translation>
    </message>
    <message>
        <source>Line %1 %2 of %3</source>
        <translation>Zeile %1 %2 von %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 added</source>
        <translation>%1: %2 %3 hinzugefügt</translation>
    </message>
    <message>
        <source>%1: %2 %3 removed</source>
        <translation>%1: %2 %3 entfernt</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <comment>line and instruction, before, after</comment>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <comment>line and instruction, operand, before, after</comment>
        <translation>%1: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Line %1 added: %2</source>
        <translation>Zeile %1 hinzugefügt: %2</translation>
    </message>
    <message>
        <source>Line %1 added: %2 (new point: %3)</source>
        <translation>Zeile %1 hinzugefügt: %2 (neuer Punkt: %3)</translation>
    </message>
    <message>
        <source>Line %1 removed: %2</source>
        <translation>Zeile %1 entfernt: %2</translation>
    </message>
    <message>
        <source>Line %1 removed: %2 (with its point: %3)</source>
        <translation>Zeile %1 entfernt: %2 (mit ihrem Punkt: %3)</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n Zeile von Zeile %1 nach Zeile %2 verschoben</numerusform>
            <numerusform>%n Zeilen von Zeile %1 nach Zeile %2 verschoben</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 commented out: %2</source>
        <translation>Zeile %1 auskommentiert: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer commented out: %2</source>
        <translation>Zeile %1 nicht mehr auskommentiert: %2</translation>
    </message>
    <message>
        <source>Line %1 locked against editing: %2</source>
        <translation>Zeile %1 gegen Bearbeitung gesperrt: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer locked against editing: %2</source>
        <translation>Zeile %1 nicht mehr gegen Bearbeitung gesperrt: %2</translation>
    </message>
    <message>
        <source>Line %1, comment: “%2” → “%3”</source>
        <translation>Zeile %1, Kommentar: „%2“ → „%3“</translation>
    </message>
    <message>
        <source>Line %1, comment added: “%2”</source>
        <translation>Zeile %1, Kommentar hinzugefügt: „%2“</translation>
    </message>
    <message>
        <source>Line %1, comment removed: “%2”</source>
        <translation>Zeile %1, Kommentar entfernt: „%2“</translation>
    </message>
    <message>
        <source>Line %1: %2 → %3</source>
        <translation>Zeile %1: %2 → %3</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <comment>a position</comment>
        <translation>%1 hinzugefügt: %2</translation>
    </message>
    <message>
        <source>%1 removed: %2</source>
        <comment>a position</comment>
        <translation>%1 entfernt: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a position</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>journal</name>
    <message>
        <source>%n record(s) of the journal are lost: neither the journal nor %1 could be written.</source>
        <translation>Verlorene Einträge des Journals: %n. Weder das Journal noch %1 konnte geschrieben werden.</translation>
    </message>
    <message>
        <source>%n record(s) could not be written into the journal. Orders and notes are kept in %1.</source>
        <translation>Nicht ins Journal geschriebene Einträge: %n. Befehle und Notizen werden in %1 aufbewahrt.</translation>
    </message>
    <message>
        <source>What an earlier program left for the journal cannot be read: %1</source>
        <translation>Was ein früheres Programm für das Journal hinterließ, kann nicht gelesen werden: %1</translation>
    </message>
</context>
<context>
    <name>journal::Database</name>
    <message>
        <source>The folder of the journal cannot be made.</source>
        <translation>Der Ordner des Journals kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>The journal was made by a newer version of Pendesk.</source>
        <translation>Das Journal stammt von einer neueren Version von Pendesk.</translation>
    </message>
    <message>
        <source>The damaged journal cannot be given another name.</source>
        <translation>Das beschädigte Journal kann nicht umbenannt werden.</translation>
    </message>
</context>
<context>
    <name>journal::Store</name>
    <message>
        <source>The journal cannot be written: %1. Work goes on; records wait in memory.</source>
        <translation>Das Journal kann nicht geschrieben werden: %1. Die Arbeit geht weiter; Einträge warten im Speicher.</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>das Laufwerk antwortet nicht</translation>
    </message>
</context>
<context>
    <name>models::ActiveAlarmModel</name>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>Untercode</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Zeit der Steuerung</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Zuerst gesehen</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>The controller tells the newest four alarms only, and this is not one of them. It may be active.</source>
        <translation>Die Steuerung meldet nur die vier neuesten Alarme, und dieser gehört nicht dazu. Er kann noch anstehen.</translation>
    </message>
    <message>
        <source>First seen by this computer: %1</source>
        <translation>Von diesem Rechner zuerst gesehen: %1</translation>
    </message>
</context>
<context>
    <name>models::AlarmHistoryModel</name>
    <message>
        <source>Controller time</source>
        <translation>Zeit der Steuerung</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>Untercode</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Read here</source>
        <translation>Hier gelesen</translation>
    </message>
</context>
<context>
    <name>models::CodeStatisticsModel</name>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Mean time between</source>
        <translation>Mittlerer Abstand</translation>
    </message>
    <message>
        <source>Last, controller time</source>
        <translation>Zuletzt, Zeit der Steuerung</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1 d %2 h</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>under a minute</source>
        <translation>unter einer Minute</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
</context>
<context>
    <name>models::FleetModel</name>
    <message>
        <source>ALARM</source>
        <translation>ALARM</translation>
    </message>
    <message>
        <source>HELD</source>
        <translation>GEHALTEN</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>HOLD: %1</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>LÄUFT</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>STEHT</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>NO LINK</source>
        <translation>KEINE VERBINDUNG</translation>
    </message>
    <message>
        <source>CHECKING</source>
        <translation>PRÜFUNG</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>AUS</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Umlaufzeit</translation>
    </message>
</context>
<context>
    <name>models::IncidentModel</name>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>models::IoModel</name>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>models::JobListModel</name>
    <message>
        <source>%1 is being executed.</source>
        <translation>%1 wird gerade ausgeführt.</translation>
    </message>
    <message>
        <source>%1, favourite</source>
        <translation>%1, Favorit</translation>
    </message>
</context>
<context>
    <name>models::OrderModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Wovon</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>models::QueueModel</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>done, read back identical</source>
        <translation>fertig, identisch zurückgelesen</translation>
    </message>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>fertig, die Steuerung hat %n Zeile umformatiert</numerusform>
            <numerusform>fertig, die Steuerung hat %n Zeilen umformatiert</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ read back different</source>
        <translation>▲ abweichend zurückgelesen</translation>
    </message>
    <message>
        <source>▲ sent, but it could not be read back</source>
        <translation>▲ gesendet, konnte aber nicht zurückgelesen werden</translation>
    </message>
    <message>
        <source>← to the computer</source>
        <translation>← zum Rechner</translation>
    </message>
    <message>
        <source>→ to the controller</source>
        <translation>→ zur Steuerung</translation>
    </message>
    <message>
        <source>✕ delete</source>
        <translation>✕ löschen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>Verbleibend</translation>
    </message>
</context>
<context>
    <name>models::TrackModel</name>
    <message>
        <source>Not read at that time.</source>
        <translation>Zu dieser Zeit nicht gelesen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Min in view</source>
        <translation>Min. im Bild</translation>
    </message>
    <message>
        <source>Max in view</source>
        <translation>Max. im Bild</translation>
    </message>
</context>
<context>
    <name>models::VariableModel</name>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>%1 (local)</source>
        <translation>%1 (lokal)</translation>
    </message>
    <message>
        <source>wrote %1, reads %2</source>
        <translation>%1 geschrieben, %2 gelesen</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <comment>old and new value</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>noch nicht gesendet</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>nicht gesendet: %1</translation>
    </message>
    <message>
        <source>being written…</source>
        <translation>wird geschrieben…</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>outcome unknown, look at the robot: %1</source>
        <translation>Ausgang unbekannt, nach dem Roboter sehen: %1</translation>
    </message>
    <message>
        <source>accepted, but another value was read back</source>
        <translation>angenommen, aber ein anderer Wert wurde zurückgelesen</translation>
    </message>
    <message>
        <source>The controller calls it “%1”.</source>
        <translation>Die Steuerung nennt sie „%1“.</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>B007, value: 17</comment>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>(leer)</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>%1 gelesen</translation>
    </message>
    <message>
        <source>→ %1</source>
        <comment>new value</comment>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
</context>
<context>
    <name>models::WatchModel</name>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>In jobs</source>
        <translation>In Jobs</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Rising edges</source>
        <translation>Steigende Flanken</translation>
    </message>
    <message>
        <source>Falling edges</source>
        <translation>Fallende Flanken</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
</context>
<context>
    <name>motion::JogStep</name>
    <message>
        <source>A step must be above 0 and at most %1 pulses.</source>
        <translation>Ein Schritt muss größer als 0 sein und darf höchstens %1 Impulse betragen.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1 mm.</source>
        <translation>Ein Schritt muss größer als 0 sein und darf höchstens %1 mm betragen.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1°.</source>
        <translation>Ein Schritt muss größer als 0 sein und darf höchstens %1° betragen.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>Die aktuelle Position wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The group has no such axis.</source>
        <translation>Die Gruppe hat keine solche Achse.</translation>
    </message>
</context>
<context>
    <name>motion::Plan</name>
    <message>
        <source>The speed must be above 0 and at most %1 mm/s.</source>
        <translation>Die Geschwindigkeit muss größer als 0 sein und darf höchstens %1 mm/s betragen.</translation>
    </message>
    <message>
        <source>The rotation speed must be above 0 and at most %1 °/s.</source>
        <translation>Die Drehgeschwindigkeit muss größer als 0 sein und darf höchstens %1 °/s betragen.</translation>
    </message>
    <message>
        <source>The joint speed must be above 0 and at most %1 %.</source>
        <translation>Die Achsgeschwindigkeit muss größer als 0 sein und darf höchstens %1 % betragen.</translation>
    </message>
    <message>
        <source>Where this frame stands cannot be read over HSES, so nobody here knows how far the move would go: use the base frame or an increment.</source>
        <translation>Wo dieses Koordinatensystem liegt, lässt sich über HSES nicht lesen; deshalb ist hier nicht bekannt, wie weit die Bewegung gehen würde: Benutzen Sie das Basiskoordinatensystem oder ein Inkrement.</translation>
    </message>
    <message>
        <source>This robot stands on base axes, and HSES does not tell where they are in mm: enter where they shall be.</source>
        <translation>Dieser Roboter steht auf Basisachsen, und HSES nennt deren Position nicht in mm: Geben Sie ein, wo sie stehen sollen.</translation>
    </message>
    <message>
        <source>The position has no six axes.</source>
        <translation>Die Position hat keine sechs Achsen.</translation>
    </message>
    <message>
        <source>The tool point stands outside the box of this controller.</source>
        <translation>Der Werkzeugpunkt steht außerhalb des Grenzquaders dieser Steuerung.</translation>
    </message>
    <message>
        <source>The move would leave the box of this controller.</source>
        <translation>Die Bewegung würde den Grenzquader dieser Steuerung verlassen.</translation>
    </message>
    <message>
        <source>User and tool frames are off until the profile says that they were checked on the robot.</source>
        <translation>Benutzer- und Werkzeugkoordinatensystem sind gesperrt, bis das Profil sagt, dass sie am Roboter geprüft wurden.</translation>
    </message>
    <message>
        <source>The user frame must be from 1 to 63.</source>
        <translation>Das Benutzerkoordinatensystem muss von 1 bis 63 sein.</translation>
    </message>
    <message>
        <source>The tool must be from 0 to 63.</source>
        <translation>Das Werkzeug muss von 0 bis 63 sein.</translation>
    </message>
    <message>
        <source>A base or a station is moved in pulses.</source>
        <translation>Eine Basisachse oder eine Station wird in Impulsen bewegt.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>Die aktuelle Position wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>A target in pulses can only be reached by a joint move: how far the tool point would go, and so how fast, is not known here.</source>
        <translation>Ein Ziel in Impulsen lässt sich nur mit einer Achsbewegung erreichen: Wie weit und damit wie schnell sich der Werkzeugpunkt bewegen würde, ist hier nicht bekannt.</translation>
    </message>
    <message>
        <source>This controller has a box, and where pulses lead is not known here: use the base frame.</source>
        <translation>Diese Steuerung hat einen Grenzquader, und wohin Impulse führen, ist hier nicht bekannt: Benutzen Sie das Basiskoordinatensystem.</translation>
    </message>
</context>
<context>
    <name>names::Sentences</name>
    <message>
        <source>%1 has no signal #%2.</source>
        <translation>%1 hat kein Signal #%2.</translation>
    </message>
    <message>
        <source>There is no #%1: the last digit of a signal is 0 to 7.</source>
        <translation>Ein #%1 gibt es nicht: Die letzte Ziffer eines Signals ist 0 bis 7.</translation>
    </message>
    <message>
        <source>There is no %1#(%2): this controller has %1#(1) to %1#(%3).</source>
        <translation>Ein %1#(%2) gibt es nicht: Diese Steuerung hat %1#(1) bis %1#(%3).</translation>
    </message>
    <message>
        <source>“%1” is not a signal. Write #00010, IN#(1) or OT#(1).</source>
        <translation>„%1“ ist kein Signal. Schreiben Sie #00010, IN#(1) oder OT#(1).</translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message>
        <source>Active alarms</source>
        <translation>Anstehende Alarme</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Alle quittieren</translation>
    </message>
    <message>
        <source>Acknowledging is noted on this computer only. The robot does not hear of it.</source>
        <translation>Quittiert wird nur auf diesem Rechner. Der Roboter erfährt davon nichts.</translation>
    </message>
    <message>
        <source>Choose one or more alarms in the table first.</source>
        <translation>Wählen Sie zuerst einen oder mehrere Alarme in der Tabelle.</translation>
    </message>
    <message>
        <source>Whether there is an alarm is not known now.</source>
        <translation>Ob ein Alarm ansteht, ist zurzeit nicht bekannt.</translation>
    </message>
    <message>
        <source>There is no alarm to clear.</source>
        <translation>Es gibt keinen Alarm zurückzusetzen.</translation>
    </message>
    <message>
        <source>Clears the alarms whose causes are gone.</source>
        <translation>Setzt die Alarme zurück, deren Ursache behoben ist.</translation>
    </message>
    <message>
        <source>Clears, if the cause is gone: %1.</source>
        <translation>Setzt zurück, falls die Ursache behoben ist: %1.</translation>
    </message>
    <message>
        <source>Whether there is an error is not known now.</source>
        <translation>Ob ein Fehler ansteht, ist zurzeit nicht bekannt.</translation>
    </message>
    <message>
        <source>Clears the error message at the pendant, and no alarm.</source>
        <translation>Löscht die Fehlermeldung am Programmierhandgerät, aber keinen Alarm.</translation>
    </message>
    <message>
        <source>There is no error to clear.</source>
        <translation>Es gibt keinen Fehler zu löschen.</translation>
    </message>
    <message>
        <source>Not connected: nothing is known of the active alarms.</source>
        <translation>Nicht verbunden: Über anstehende Alarme ist nichts bekannt.</translation>
    </message>
    <message>
        <source>The alarms have not been read yet.</source>
        <translation>Die Alarme wurden noch nicht gelesen.</translation>
    </message>
    <message>
        <source>The controller does not tell its alarms.</source>
        <translation>Die Steuerung meldet ihre Alarme nicht.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>%n Alarm stand zuletzt an.</numerusform>
            <numerusform>%n Alarme standen zuletzt an.</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>Kein Alarm steht an.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>%n Alarm steht an, der neueste zuerst.</numerusform>
            <numerusform>%n Alarme stehen an, der neueste zuerst.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset accepted. Reading the alarms…</source>
        <translation>Zurücksetzen angenommen. Die Alarme werden gelesen…</translation>
    </message>
    <message>
        <source>Reset accepted. Whether an alarm is left is not known: the status cannot be read.</source>
        <translation>Zurücksetzen angenommen. Ob noch ein Alarm ansteht, ist nicht bekannt: Der Status kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Reset accepted. No alarm is active any more.</source>
        <translation>Zurücksetzen angenommen. Es steht kein Alarm mehr an.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first.</source>
        <translation>▲ Angenommen, steht noch an: Zuerst die Ursache beheben.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first. Left are: %1.</source>
        <translation>▲ Angenommen, steht noch an: Zuerst die Ursache beheben. Es bleiben: %1.</translation>
    </message>
    <message>
        <source>Cancel error accepted.</source>
        <translation>Fehler löschen angenommen.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Past alarms</source>
        <translation>Vergangene Alarme</translation>
    </message>
    <message>
        <source>Most frequent</source>
        <translation>Häufigste</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>All lists</source>
        <translation>Alle Listen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search code, text or time</source>
        <translation>Code, Text oder Zeit suchen</translation>
    </message>
    <message>
        <source>Most frequent alarms</source>
        <translation>Häufigste Alarme</translation>
    </message>
    <message>
        <source>Counted in everything this journal has of the controller. The times between are by the controller&apos;s clock; steps of that clock are left out.</source>
        <translation>Gezählt wird in allem, was dieses Journal von der Steuerung enthält. Die Zeitabstände richten sich nach der Uhr der Steuerung; Sprünge dieser Uhr werden ausgelassen.</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>Notiz zu %1</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Lesen anhalten</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>Jetzt lesen</translation>
    </message>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>Der Verlauf wird aus der Steuerung gelesen: %n Eintrag gelesen.</numerusform>
            <numerusform>Der Verlauf wird aus der Steuerung gelesen: %n Einträge gelesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>Das Journal kann nicht gelesen werden: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>Das Lesen wurde angehalten. %n Eintrag im Journal.</numerusform>
            <numerusform>Das Lesen wurde angehalten. %n Einträge im Journal.</numerusform>
        </translation>
    </message>
    <message>
        <source>The history could not be read to its end: %1.</source>
        <translation>Der Verlauf konnte nicht bis zum Ende gelesen werden: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>Der neueste %n Eintrag des Journals; der Export enthält alle.</numerusform>
            <numerusform>Die neuesten %n Einträge des Journals; der Export enthält alle.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>%n Eintrag im Journal, auf Dauer aufbewahrt.</numerusform>
            <numerusform>%n Einträge im Journal, auf Dauer aufbewahrt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export past alarms</source>
        <translation>Vergangene Alarme exportieren</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>%n Eintrag exportiert.</numerusform>
            <numerusform>%n Einträge exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>Nicht exportiert: %1.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message>
        <source>Save note</source>
        <translation>Notiz speichern</translation>
    </message>
    <message>
        <source>Export notes…</source>
        <translation>Notizen exportieren…</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>%n Notiz exportiert.</numerusform>
            <numerusform>%n Notizen exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>Nicht exportiert: %1.</translation>
    </message>
    <message>
        <source>Export notes</source>
        <translation>Notizen exportieren</translation>
    </message>
    <message>
        <source>Codes with a note</source>
        <translation>Codes mit Notiz</translation>
    </message>
    <message>
        <source>Alarm code</source>
        <translation>Alarmcode</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>What we did</source>
        <translation>Was wir getan haben</translation>
    </message>
    <message>
        <source>The notes cannot be read: %1.</source>
        <translation>Die Notizen können nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>No note yet.</source>
        <translation>Noch keine Notiz.</translation>
    </message>
    <message>
        <source>Last changed by %1, %2.</source>
        <translation>Zuletzt geändert von %1, %2.</translation>
    </message>
</context>
<context>
    <name>pages::AxesCard</name>
    <message>
        <source>pulses</source>
        <translation>Impulse</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>following error, pulses</source>
        <translation>Schleppfehler, Impulse</translation>
    </message>
    <message>
        <source>torque, raw</source>
        <translation>Drehmoment, roh</translation>
    </message>
    <message>
        <source>As the controller sends it: the unit is stated nowhere.</source>
        <translation>Wie die Steuerung es sendet: Die Einheit ist nirgends angegeben.</translation>
    </message>
    <message>
        <source>encoder, °C</source>
        <translation>Geber, °C</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C</source>
        <translation>Umrichter %1: %2 °C</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C, last seen %3</source>
        <translation>Umrichter %1: %2 °C, zuletzt gesehen %3</translation>
    </message>
    <message>
        <source>Converter temperature: %1</source>
        <translation>Umrichtertemperatur: %1</translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source> newest</source>
        <translation> neueste</translation>
    </message>
    <message>
        <source>Keep any number</source>
        <translation>Beliebig viele behalten</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source>Keep any age</source>
        <translation>Beliebig alte behalten</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Jetzt sichern</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Anheften</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>Gut: Jedes Byte von %n Datei ist so, wie es geschrieben wurde.</numerusform>
            <numerusform>Gut: Jedes Byte von %n Dateien ist so, wie es geschrieben wurde.</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ Not good: %1</source>
        <translation>▲ Nicht gut: %1</translation>
    </message>
    <message>
        <source>After a backup keep</source>
        <translation>Nach einer Sicherung behalten</translation>
    </message>
    <message>
        <source>The last good backup and pinned ones are never deleted.</source>
        <translation>Die letzte gute Sicherung und angeheftete werden nie gelöscht.</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>with the backup before</source>
        <translation>mit der Sicherung davor</translation>
    </message>
    <message>
        <source>with the newest backup</source>
        <translation>mit der neuesten Sicherung</translation>
    </message>
    <message>
        <source>with the controller now</source>
        <translation>mit der Steuerung jetzt</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>Zurückspielen…</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>In %1</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Choose a backup first.</source>
        <translation>Wählen Sie zuerst eine Sicherung.</translation>
    </message>
    <message>
        <source>Files are being read.</source>
        <translation>Dateien werden gerade gelesen.</translation>
    </message>
    <message>
        <source>Reading file %1 of %2…</source>
        <translation>Datei %1 von %2 wird gelesen…</translation>
    </message>
    <message>
        <source>Reading the lists…</source>
        <translation>Die Listen werden gelesen…</translation>
    </message>
    <message>
        <source>▲ There is no new backup: %1</source>
        <translation>▲ Es gibt keine neue Sicherung: %1</translation>
    </message>
    <message>
        <source>▲ %1 of %2 files were backed up.</source>
        <translation>▲ %1 von %2 Dateien wurden gesichert.</translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>%n Datei wurde gesichert, das sind alle.</numerusform>
            <numerusform>Alle %n Dateien wurden gesichert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading every byte…</source>
        <translation>Jedes Byte wird gelesen…</translation>
    </message>
    <message>
        <source>There is no other backup to compare with.</source>
        <translation>Es gibt keine andere Sicherung zum Vergleichen.</translation>
    </message>
    <message>
        <source>The controller&apos;s files were read.</source>
        <translation>Die Dateien der Steuerung wurden gelesen.</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>Ordner der Sicherungen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Exported.</source>
        <translation>Exportiert.</translation>
    </message>
    <message>
        <source>▲ Not exported: %1</source>
        <translation>▲ Nicht exportiert: %1</translation>
    </message>
    <message>
        <source>Export the backup</source>
        <translation>Sicherung exportieren</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Zip-Dateien (*.zip)</translation>
    </message>
    <message>
        <source>Exporting to %1…</source>
        <translation>Wird nach %1 exportiert…</translation>
    </message>
    <message>
        <source>the controller now</source>
        <translation>die Steuerung jetzt</translation>
    </message>
</context>
<context>
    <name>pages::CartesianCard</name>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>Werkzeugpunkt</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>Erweiterte Stellung</translation>
    </message>
    <message>
        <source>%1 · base frame, tool %2</source>
        <translation>%1 · Basis, Werkzeug %2</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · Basis</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 hat keinen Werkzeugpunkt: HSES nennt ihn nur für Roboter.</translation>
    </message>
    <message>
        <source>%1, base frame, tool %2</source>
        <translation>%1, Basis, Werkzeug %2</translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message>
        <source>≠ changed</source>
        <translation>≠ geändert</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ neu</translation>
    </message>
    <message>
        <source>− gone</source>
        <translation>− weg</translation>
    </message>
    <message>
        <source>▲ not read, nobody knows</source>
        <translation>▲ nicht gelesen, nicht bekannt</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>Abweichende Dateien</translation>
    </message>
    <message>
        <source>Choose a backup and compare it.</source>
        <translation>Wählen Sie eine Sicherung, und vergleichen Sie sie.</translation>
    </message>
    <message>
        <source>Not counted as a difference:</source>
        <translation>Zählt nicht als Unterschied:</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>%n Datei weicht ab</numerusform>
            <numerusform>%n Dateien weichen ab</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a file above.</source>
        <translation>Wählen Sie oben eine Datei.</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>Nichts weicht ab.</translation>
    </message>
    <message>
        <source>This file is not in the backup as it was written.</source>
        <translation>Diese Datei ist in der Sicherung nicht so, wie sie geschrieben wurde.</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>nicht gezählt</translation>
    </message>
    <message>
        <source>Comparison: from %1 to %2</source>
        <translation>Vergleich: von %1 nach %2</translation>
    </message>
    <message>
        <source>The files are being compared…</source>
        <translation>Die Dateien werden verglichen…</translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>Nicht gezählt: %n Datei mit Zählern, Protokollen und dergleichen</numerusform>
            <numerusform>Nicht gezählt: %n Dateien mit Zählern, Protokollen und dergleichen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::CycleCard</name>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>Tatsächlich</translation>
    </message>
    <message>
        <source>Requested here</source>
        <translation>Hier angefordert</translation>
    </message>
    <message>
        <source>Nothing was requested from here.</source>
        <translation>Von hier wurde nichts angefordert.</translation>
    </message>
    <message>
        <source>Cycle mode to request</source>
        <translation>Anzufordernde Zyklusart</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Anfordern</translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilesPage</name>
    <message>
        <source>This computer</source>
        <translation>Dieser Rechner</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>← Fetch</source>
        <translation>← Holen</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Folder of the files</source>
        <translation>Ordner der Dateien</translation>
    </message>
    <message>
        <source>Type of the files</source>
        <translation>Typ der Dateien</translation>
    </message>
    <message>
        <source>Send →</source>
        <translation>Senden →</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>There are no controller files in this folder.</source>
        <translation>In diesem Ordner sind keine Dateien für Steuerungen.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>Die Liste wird gelesen…</translation>
    </message>
    <message>
        <source>The controller lists no files of this type.</source>
        <translation>Die Steuerung führt keine Dateien dieses Typs auf.</translation>
    </message>
    <message>
        <source>Choose files on the left first.</source>
        <translation>Wählen Sie zuerst links Dateien.</translation>
    </message>
    <message>
        <source>Choose files on the right first.</source>
        <translation>Wählen Sie zuerst rechts Dateien.</translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Size of the tiles</source>
        <translation>Größe der Kacheln</translation>
    </message>
    <message>
        <source>HOLD ALL</source>
        <translation>HOLD ALLE</translation>
    </message>
    <message>
        <source>HOLD all controllers (software)</source>
        <translation>HOLD für alle Steuerungen (Software)</translation>
    </message>
    <message>
        <source>every station that is not off</source>
        <translation>jede Station, die nicht AUS ist</translation>
    </message>
    <message>
        <source>Connect all</source>
        <translation>Alle verbinden</translation>
    </message>
    <message>
        <source>Back up all</source>
        <translation>Alle sichern</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Tafel</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Controllers</source>
        <translation>Steuerungen</translation>
    </message>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>%n Steuerung</numerusform>
            <numerusform>%n Steuerungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n verbunden</numerusform>
            <numerusform>%n verbunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>%n ohne Verbindung</numerusform>
            <numerusform>%n ohne Verbindung</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>%n Station, die nicht AUS ist</numerusform>
            <numerusform>%n Stationen, die nicht AUS sind</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ HOLD was not confirmed by %1: look at the robot.</source>
        <translation>▲ HOLD wurde von %1 nicht bestätigt: Sehen Sie nach dem Roboter.</translation>
    </message>
    <message>
        <source>HOLD is being asked of %1.</source>
        <translation>HOLD wird von %1 angefordert.</translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>HOLD wurde von %n Steuerung bestätigt.</numerusform>
            <numerusform>HOLD wurde von %n Steuerungen bestätigt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::GroupCard</name>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
</context>
<context>
    <name>pages::HoldCard</name>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Gehalten durch</translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message>
        <source>User in</source>
        <translation>Benutzer E</translation>
    </message>
    <message>
        <source>User out</source>
        <translation>Benutzer A</translation>
    </message>
    <message>
        <source>External in</source>
        <translation>Extern E</translation>
    </message>
    <message>
        <source>Network in</source>
        <translation>Netzwerk E</translation>
    </message>
    <message>
        <source>External out</source>
        <translation>Extern A</translation>
    </message>
    <message>
        <source>Network out</source>
        <translation>Netzwerk A</translation>
    </message>
    <message>
        <source>System in</source>
        <translation>System E</translation>
    </message>
    <message>
        <source>System out</source>
        <translation>System A</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Bedienfeld</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>Relais</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerstatus</translation>
    </message>
    <message>
        <source>Pseudo in</source>
        <translation>Pseudo E</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>Ab 0 zählen</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Over HSES only network inputs can be written: this lamp only shows.</source>
        <translation>Über HSES lassen sich nur Netzwerkeingänge schreiben: Diese Lampe zeigt nur an.</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Schreiben…</translation>
    </message>
    <message>
        <source>Name it here…</source>
        <translation>Hier benennen…</translation>
    </message>
    <message>
        <source>Take the local name away</source>
        <translation>Lokalen Namen entfernen</translation>
    </message>
    <message>
        <source>Watch no longer</source>
        <translation>Nicht mehr beobachten</translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation>Adresse kopieren</translation>
    </message>
    <message>
        <source>Edges are counted from what is read four times a second; shorter pulses are not seen.</source>
        <translation>Flanken werden aus dem gezählt, was viermal pro Sekunde gelesen wird; kürzere Impulse bleiben unbemerkt.</translation>
    </message>
    <message>
        <source>Network inputs can be written: press Enter on a lamp.</source>
        <translation>Netzwerkeingänge lassen sich schreiben: Drücken Sie auf einer Lampe die Eingabetaste.</translation>
    </message>
    <message>
        <source>These lamps only show: over HSES only network inputs can be written.</source>
        <translation>Diese Lampen zeigen nur an: Über HSES lassen sich nur Netzwerkeingänge schreiben.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>%n Gruppe ab %1 wird abgelehnt: %2.</numerusform>
            <numerusform>%n Gruppen ab %1 werden abgelehnt: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The controller&apos;s names are not known: %1.</source>
        <translation>Die Namen der Steuerung sind nicht bekannt: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>%n Zeile von IONAME.DAT konnte nicht gelesen werden.</numerusform>
            <numerusform>%n Zeilen von IONAME.DAT konnten nicht gelesen werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Area of signals</source>
        <translation>Signalbereich</translation>
    </message>
    <message>
        <source>Watched signals</source>
        <translation>Beobachtete Signale</translation>
    </message>
</context>
<context>
    <name>pages::JobCard</name>
    <message>
        <source>master task</source>
        <translation>Mastertask</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Geschwindigkeits-Override</translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message>
        <source>Jobs on the controller</source>
        <translation>Jobs auf der Steuerung</translation>
    </message>
    <message>
        <source>★ Favourite</source>
        <translation>★ Favorit</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter jobs by name</source>
        <translation>Jobs nach Namen filtern</translation>
    </message>
    <message>
        <source>The list could not be read: %1.</source>
        <translation>Die Liste konnte nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>Die Liste wird gelesen…</translation>
    </message>
    <message>
        <source>The list was not read yet.</source>
        <translation>Die Liste wurde noch nicht gelesen.</translation>
    </message>
    <message>
        <source>There is no job on the controller.</source>
        <translation>Auf der Steuerung ist kein Job.</translation>
    </message>
    <message>
        <source>No job has “%1” in its name.</source>
        <translation>Kein Job hat „%1“ im Namen.</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>%n Job</numerusform>
            <numerusform>%n Jobs</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, read at %2</source>
        <translation>%1, gelesen um %2</translation>
    </message>
</context>
<context>
    <name>pages::JobTextCard</name>
    <message>
        <source>Job text</source>
        <translation>Jobtext</translation>
    </message>
    <message>
        <source>Choose a job in the list to read it.</source>
        <translation>Wählen Sie einen Job in der Liste, um ihn zu lesen.</translation>
    </message>
    <message>
        <source>Follow what is executed</source>
        <translation>Der Ausführung folgen</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Neu lesen</translation>
    </message>
    <message>
        <source>Labels and calls</source>
        <translation>Marken und Aufrufe</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>line and label</comment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message>
        <source>read at %1</source>
        <translation>gelesen um %1</translation>
    </message>
    <message>
        <source>The job could not be read: %1.</source>
        <translation>Der Job konnte nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.</source>
        <translation>Gelesen um %1. Seitdem war die Steuerung in TEACH oder die Verbindung verloren: Diese Kopie kann veraltet sein.</translation>
    </message>
    <message>
        <source>Reading the job…</source>
        <translation>Der Job wird gelesen…</translation>
    </message>
    <message>
        <source>The job was not read yet.</source>
        <translation>Der Job wurde noch nicht gelesen.</translation>
    </message>
    <message>
        <source>This file holds no instructions that could be shown.</source>
        <translation>Diese Datei enthält keine Anweisungen, die gezeigt werden könnten.</translation>
    </message>
</context>
<context>
    <name>pages::JobsPage</name>
    <message>
        <source>Orders</source>
        <translation>Befehle</translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message>
        <source>Jog</source>
        <translation>Tippbetrieb</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>Keyboard too: hold Ctrl and Space on the button that has the focus</source>
        <translation>Auch Tastatur: Strg und Leertaste auf der Schaltfläche mit dem Fokus gedrückt halten</translation>
    </message>
    <message>
        <source>Hold a button: one bounded step after another</source>
        <translation>Schaltfläche gedrückt halten: ein begrenzter Schritt nach dem anderen</translation>
    </message>
    <message>
        <source>After a lost link</source>
        <translation>Nach Verlust der Verbindung</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>Letzter Schritt</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Basis</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Axes (pulses)</source>
        <translation>Achsen (Impulse)</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 mm/s · %2 °/s</source>
        <translation>%1 mm/s · %2 °/s</translation>
    </message>
    <message>
        <source>at most one step: %1 pulses</source>
        <translation>höchstens ein Schritt: %1 Impulse</translation>
    </message>
    <message>
        <source>at most one step: %1 mm or %2°, in %3 s at most</source>
        <translation>höchstens ein Schritt: %1 mm oder %2°, in höchstens %3 s</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>Aus: Das Profil hat eine Bewegungsgrenze, die keine Zahl über 0 ist (%1).</translation>
    </message>
    <message>
        <source>No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.</source>
        <translation>Keine Antwort auf den Schritt: Ob er ausgeführt wurde, ist unbekannt. HOLD wurde gesendet. Sehen Sie nach dem Roboter.</translation>
    </message>
    <message>
        <source>Step sent…</source>
        <translation>Schritt gesendet…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>In Bewegung…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%n Schritt, in Ruhe.</numerusform>
            <numerusform>%n Schritte, in Ruhe.</numerusform>
        </translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Noch keiner.</translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message>
        <source>At any time</source>
        <translation>Jederzeit</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>Alle Steuerungen</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Any outcome</source>
        <translation>Jeder Ausgang</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search in all texts</source>
        <translation>In allen Texten suchen</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>Das Journal wird gelesen…</translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>Das Journal kann nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>Nothing was tried that fits this filter.</source>
        <translation>Zu diesem Filter gibt es keinen Vorgang.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>Der neueste %n Eintrag. Für ältere nach unten blättern.</numerusform>
            <numerusform>Die neuesten %n Einträge. Für ältere nach unten blättern.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n Eintrag</numerusform>
            <numerusform>%n Einträge</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a record to read all of it here.</source>
        <translation>Wählen Sie einen Eintrag, um ihn hier ganz zu lesen.</translation>
    </message>
    <message>
        <source>%1: %2 at %3.</source>
        <translation>%1: %2 an %3.</translation>
    </message>
    <message>
        <source>Outcome: %1.</source>
        <translation>Ausgang: %1.</translation>
    </message>
    <message>
        <source>By %1 at %2, level %3.</source>
        <translation>Von %1 an %2, Stufe %3.</translation>
    </message>
    <message>
        <source>Export the journal</source>
        <translation>Journal exportieren</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>%n Eintrag exportiert.</numerusform>
            <numerusform>%n Einträge exportiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>Nicht exportiert: %1.</translation>
    </message>
</context>
<context>
    <name>pages::LinkCard</name>
    <message>
        <source>%1 repeated</source>
        <translation>%1 wiederholt</translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation>%1 unbeantwortet</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>%1 verspätet</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 doppelt</translation>
    </message>
    <message>
        <source>%1 mismatched</source>
        <translation>%1 unpassend</translation>
    </message>
    <message>
        <source>%1 malformed</source>
        <translation>%1 fehlerhaft</translation>
    </message>
    <message>
        <source>%1 from elsewhere</source>
        <translation>%1 von anderswo</translation>
    </message>
    <message>
        <source>%1 busy</source>
        <translation>%1 belegt</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>letzte 60 s</translation>
    </message>
    <message>
        <source>round trip p50 / p95</source>
        <translation>Umlaufzeit p50 / p95</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>last answer</source>
        <translation>letzte Antwort</translation>
    </message>
    <message>
        <source>sent / answered</source>
        <translation>gesendet / beantwortet</translation>
    </message>
    <message>
        <source>unusual</source>
        <translation>Auffälliges</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 /s of %2</source>
        <translation>%1 /s von %2</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>vor %1</translation>
    </message>
</context>
<context>
    <name>pages::MotionPage</name>
    <message>
        <source>Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody may be inside the fence.</source>
        <translation>Fernbewegung im Automatikbetrieb. Der Zustimmungsschalter des Programmierhandgeräts schützt hier niemanden. Niemand darf sich innerhalb des Schutzzauns aufhalten.</translation>
    </message>
    <message>
        <source>Before each step</source>
        <translation>Vor jedem Schritt</translation>
    </message>
    <message>
        <source>Control group that moves</source>
        <translation>Achsgruppe, die sich bewegt</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>Achsgruppe</translation>
    </message>
</context>
<context>
    <name>pages::MoveCard</name>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Type of the move</source>
        <translation>Art der Bewegung</translation>
    </message>
    <message>
        <source>Frame of the target</source>
        <translation>Koordinatensystem des Ziels</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>Benutzerkoordinatensystem</translation>
    </message>
    <message>
        <source>Base axes in mm</source>
        <translation>Basisachsen in mm</translation>
    </message>
    <message>
        <source>Rehearse…</source>
        <translation>Vorab prüfen…</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Achsbewegung</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Geradlinig</translation>
    </message>
    <message>
        <source>Straight, increment</source>
        <translation>Geradlinig, Inkrement</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>Basiskoordinatensystem</translation>
    </message>
    <message>
        <source>Robot frame</source>
        <translation>Roboterkoordinatensystem</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>Werkzeugkoordinatensystem</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Impulse</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Koordinatensystem</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>Speed in mm/s</source>
        <translation>Geschwindigkeit in mm/s</translation>
    </message>
    <message>
        <source>Rotation speed in °/s</source>
        <translation>Drehgeschwindigkeit in °/s</translation>
    </message>
    <message>
        <source>Joint speed in %</source>
        <translation>Achsgeschwindigkeit in %</translation>
    </message>
    <message>
        <source>mm/s, at most %1</source>
        <translation>mm/s, höchstens %1</translation>
    </message>
    <message>
        <source>°/s, at most %1</source>
        <translation>°/s, höchstens %1</translation>
    </message>
    <message>
        <source>% of joint speed, at most %1</source>
        <translation>% der Achsgeschwindigkeit, höchstens %1</translation>
    </message>
    <message>
        <source>Target of %1 in %2</source>
        <translation>Ziel von %1 in %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There are three base axes at most.</source>
        <translation>Es gibt höchstens drei Basisachsen.</translation>
    </message>
    <message>
        <source>Base axes: %1</source>
        <translation>Basisachsen: %1</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>Aus: Das Profil hat eine Bewegungsgrenze, die keine Zahl über 0 ist (%1).</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <translation>Stellung: %1</translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message>
        <source>Before sending</source>
        <translation>Vor dem Senden</translation>
    </message>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>%n Datei senden</numerusform>
            <numerusform>%n Dateien senden</numerusform>
        </translation>
    </message>
    <message>
        <source>on this computer</source>
        <translation>auf diesem Rechner</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>What would change in “%1”</source>
        <translation>Was sich in „%1“ ändern würde</translation>
    </message>
</context>
<context>
    <name>pages::OptionsCard</name>
    <message>
        <source>always: the button above, the Pause key or Ctrl+Shift+H.</source>
        <translation>immer: die Schaltfläche oben, die Pause-Taste oder Strg+Umschalt+H.</translation>
    </message>
    <message>
        <source>sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.</source>
        <translation>wird wiederholt gesendet, bis es bestätigt ist oder 2 s vergangen sind. Halten Sie das Programmierhandgerät bereit.</translation>
    </message>
    <message>
        <source>there is no connection: use the pendant.</source>
        <translation>es besteht keine Verbindung: Programmierhandgerät benutzen.</translation>
    </message>
    <message>
        <source>What can I do now?</source>
        <translation>Was ist jetzt möglich?</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>possible</source>
        <translation>möglich</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>nicht möglich</translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message>
        <source>Pendant</source>
        <translation>Programmierhandgerät</translation>
    </message>
    <message>
        <source>Message for the pendant</source>
        <translation>Meldung für das Programmierhandgerät</translation>
    </message>
    <message>
        <source>Show on the pendant</source>
        <translation>Auf dem Programmierhandgerät zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 von %n Byte</numerusform>
            <numerusform>%1 von %n Byte</numerusform>
        </translation>
    </message>
    <message>
        <source>Type a message first.</source>
        <translation>Geben Sie zuerst eine Meldung ein.</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding cannot hold this: %1.</source>
        <translation>Die Kodierung der Steuerung kann das nicht darstellen: %1.</translation>
    </message>
    <message>
        <source>The message is too long for the pendant.</source>
        <translation>Die Meldung ist zu lang für das Programmierhandgerät.</translation>
    </message>
    <message>
        <source>HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.</source>
        <translation>HLOCK wurde von hier eingeschaltet: Das Programmierhandgerät ist gesperrt, außer seinem Not-Halt.</translation>
    </message>
    <message>
        <source>HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not switched on.</source>
        <translation>HLOCK sperrt das Programmierhandgerät. Ob es eingeschaltet ist, lässt sich über HSES nicht lesen; von hier wurde es nicht eingeschaltet.</translation>
    </message>
</context>
<context>
    <name>pages::PointsBar</name>
    <message>
        <source>Take the present position</source>
        <translation>Aktuelle Position übernehmen</translation>
    </message>
    <message>
        <source>Take P</source>
        <translation>P übernehmen</translation>
    </message>
    <message>
        <source>Earlier places</source>
        <translation>Frühere Positionen</translation>
    </message>
    <message>
        <source>Keep the present position as P</source>
        <translation>Aktuelle Position als P speichern</translation>
    </message>
    <message>
        <source>P variable</source>
        <translation>P-Variable</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>%1 wird gelesen…</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>%1 konnte nicht gelesen werden: %2.</translation>
    </message>
    <message>
        <source>%1 is in another frame (%2): choose that frame and an absolute move to take it.</source>
        <translation>%1 ist in einem anderen Koordinatensystem (%2): Wählen Sie zum Übernehmen dieses Koordinatensystem und eine absolute Bewegung.</translation>
    </message>
    <message>
        <source>The target is %1.</source>
        <translation>Das Ziel ist %1.</translation>
    </message>
    <message>
        <source>Only the present position of a robot can be kept, once it was read.</source>
        <translation>Nur die aktuelle Position eines Roboters lässt sich speichern, sobald sie gelesen wurde.</translation>
    </message>
    <message>
        <source>%1 was written and read back.</source>
        <translation>%1 wurde geschrieben und zurückgelesen.</translation>
    </message>
    <message>
        <source>%1 was not verified: %2.</source>
        <translation>%1 wurde nicht geprüft: %2.</translation>
    </message>
    <message>
        <source>%1 was written, but another value was read back.</source>
        <translation>%1 wurde geschrieben, aber ein anderer Wert wurde zurückgelesen.</translation>
    </message>
    <message>
        <source>No move has begun in this frame yet</source>
        <translation>In diesem Koordinatensystem hat noch keine Bewegung begonnen</translation>
    </message>
    <message>
        <source>%1 is not taught.</source>
        <translation>%1 ist nicht geteacht.</translation>
    </message>
    <message>
        <source>Other values are still being written.</source>
        <translation>Es werden noch andere Werte geschrieben.</translation>
    </message>
    <message>
        <source>%1 holds this position already.</source>
        <translation>%1 enthält diese Position schon.</translation>
    </message>
</context>
<context>
    <name>pages::PositionCard</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>R1 · base frame, tool %1  ·  pulses</source>
        <translation>R1 · Basis, Werkzeug %1  ·  Impulse</translation>
    </message>
    <message>
        <source>R1 · base frame  ·  pulses</source>
        <translation>R1 · Basis  ·  Impulse</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message>
        <source>Control groups</source>
        <translation>Achsgruppen</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>Min. und Max. zurücksetzen</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Not shown because refused: %1 of %2 control groups.</source>
        <translation>Nicht gezeigt, weil abgelehnt: %1 von %2 Achsgruppen.</translation>
    </message>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>%n Achsgruppe</numerusform>
            <numerusform>%n Achsgruppen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::QueueCard</name>
    <message>
        <source>Transfers</source>
        <translation>Übertragungen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>Fehlgeschlagene wiederholen</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>Fertige entfernen</translation>
    </message>
</context>
<context>
    <name>pages::RegistersPage</name>
    <message>
        <source>How registers are written</source>
        <translation>Schreibweise der Register</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Dezimal</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>Mit Vorzeichen</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>Hexadezimal</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binär</translation>
    </message>
    <message>
        <source>M000 to M559 can be written; the others belong to the ladder.</source>
        <translation>M000 bis M559 lassen sich schreiben; die übrigen gehören dem Kontaktplan (Ladder).</translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message>
        <source>What changes in “%1” on %2</source>
        <translation>Was sich in „%1“ auf %2 ändert</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Delete on %1</source>
        <translation>Auf %1 löschen</translation>
    </message>
    <message>
        <source>These files are deleted on %1:
%2
Before that each is copied to %3.</source>
        <translation>Diese Dateien werden auf %1 gelöscht:
%2
Vorher wird jede nach %3 kopiert.</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>%n Datei löschen</numerusform>
            <numerusform>%n Dateien löschen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::SelectCard</name>
    <message>
        <source>Select</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Select as</source>
        <translation>Wählen als</translation>
    </message>
    <message>
        <source>to be executed</source>
        <translation>auszuführender Job</translation>
    </message>
    <message>
        <source>master job</source>
        <translation>Masterjob</translation>
    </message>
    <message>
        <source>master job of sub task %1</source>
        <translation>Masterjob von Subtask %1</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>Ab Zeile</translation>
    </message>
    <message>
        <source>line </source>
        <translation>Zeile </translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>Choose a job in the list first.</source>
        <translation>Wählen Sie zuerst einen Job in der Liste.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>Task %1</translation>
    </message>
</context>
<context>
    <name>pages::SelectionCard</name>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Where it is</source>
        <translation>Aktuelle Stelle</translation>
    </message>
    <message>
        <source>master task</source>
        <translation>Mastertask</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
</context>
<context>
    <name>pages::ServoCard</name>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Servo power</source>
        <translation>Servoleistung</translation>
    </message>
    <message>
        <source>A job is running: servo off stops it at once.</source>
        <translation>Ein Job läuft: Servo aus stoppt ihn sofort.</translation>
    </message>
    <message>
        <source>Servo on…</source>
        <translation>Servo ein…</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ein</translation>
    </message>
    <message>
        <source>Switch servo power on at %1?

The robot can move from then on. Nobody may be inside the fence.</source>
        <translation>Servoleistung an %1 einschalten?

Von da an kann sich der Roboter bewegen. Niemand darf sich innerhalb des Schutzzauns aufhalten.</translation>
    </message>
</context>
<context>
    <name>pages::StartCard</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>Start…</translation>
    </message>
</context>
<context>
    <name>pages::StartPanel</name>
    <message>
        <source>Start</source>
        <translation>Startseite</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it.</source>
        <translation>Es wird nichts gelesen und nichts angezeigt. Beim Verbinden wird nur gelesen: Dadurch wird nichts geschrieben, gestartet oder bewegt.</translation>
    </message>
    <message>
        <source>Connect to a controller…</source>
        <translation>Mit einer Steuerung verbinden…</translation>
    </message>
    <message>
        <source>A controller in your network</source>
        <translation>Eine Steuerung in Ihrem Netzwerk</translation>
    </message>
    <message>
        <source>Enter its name or address. Pendesk checks step by step whether it answers, and says what is wrong where it does not.</source>
        <translation>Geben Sie ihren Namen oder ihre Adresse ein. Pendesk prüft Schritt für Schritt, ob sie antwortet, und sagt, was nicht stimmt, wenn sie es nicht tut.</translation>
    </message>
    <message>
        <source>No robot at hand</source>
        <translation>Kein Roboter zur Hand</translation>
    </message>
    <message>
        <source>The demo brings a simulated controller in this program. Everything can be tried with it, and no robot moves.</source>
        <translation>Die Demo bringt eine simulierte Steuerung in diesem Programm mit. Alles lässt sich damit ausprobieren, und kein Roboter bewegt sich.</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Recent controllers</source>
        <translation>Zuletzt verbundene Steuerungen</translation>
    </message>
    <message>
        <source>Another controller…</source>
        <translation>Andere Steuerung…</translation>
    </message>
</context>
<context>
    <name>pages::StateCard</name>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Hold · pendant</source>
        <translation>HOLD · Handgerät</translation>
    </message>
    <message>
        <source>Hold · external</source>
        <translation>HOLD · extern</translation>
    </message>
    <message>
        <source>Hold · command</source>
        <translation>HOLD · Befehl</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
</context>
<context>
    <name>pages::SystemCard</name>
    <message>
        <source>System</source>
        <translation>System</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the system information</source>
        <translation>Systeminformationen kopieren</translation>
    </message>
    <message>
        <source>The profile says %1, but this is the software of a %2: correct the profile.</source>
        <translation>Das Profil sagt %1, aber das ist die Software einer %2: Bitte das Profil berichtigen.</translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message>
        <source>Tasks</source>
        <translation>Tasks</translation>
    </message>
    <message>
        <source>Show the sub tasks</source>
        <translation>Subtasks anzeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>%n Subtask</numerusform>
            <numerusform>%n Subtasks</numerusform>
        </translation>
    </message>
    <message>
        <source>Sub task %1</source>
        <translation>Subtask %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>pages::TileDelegate</name>
    <message>
        <source>ARMED</source>
        <translation>SCHARF</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>NICHT VERBUNDEN</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>last seen: %1</source>
        <translation>zuletzt gesehen: %1</translation>
    </message>
    <message>
        <source>Servo %1</source>
        <translation>Servo %1</translation>
    </message>
</context>
<context>
    <name>pages::Timeline</name>
    <message>
        <source>▲ no backup any more</source>
        <translation>▲ keine Sicherung mehr</translation>
    </message>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ %n Datei fehlt</numerusform>
            <numerusform>▲ %n Dateien fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>%1, pinned</source>
        <translation>%1, angeheftet</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Angelegt</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Changed</source>
        <comment>number of files</comment>
        <translation>Geändert</translation>
    </message>
</context>
<context>
    <name>pages::ToolPathCard</name>
    <message>
        <source>Tool path</source>
        <translation>Werkzeugbahn</translation>
    </message>
    <message>
        <source>Clear path</source>
        <translation>Bahn löschen</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · Basis</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 hat keinen Werkzeugpunkt: HSES nennt ihn nur für Roboter.</translation>
    </message>
</context>
<context>
    <name>pages::TrendPage</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Add signal…</source>
        <translation>Signal hinzufügen…</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Freezes the view; recording goes on.</source>
        <translation>Hält die Ansicht an; die Aufzeichnung läuft weiter.</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Zurück zu Live</translation>
    </message>
    <message>
        <source>Time in view</source>
        <translation>Zeit im Bild</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Trend</translation>
    </message>
    <message>
        <source>Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in its menu, or add a signal.</source>
        <translation>Noch ist keine Kurve da. Ziehen Sie von einer beliebigen Seite eine Zahl hierher, wählen Sie „Zum Trend hinzufügen“ in ihrem Menü, oder fügen Sie ein Signal hinzu.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Remove from trend</source>
        <translation>Aus dem Trend entfernen</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>Vorfälle</translation>
    </message>
    <message>
        <source>60 s before an alarm, 20 s after</source>
        <translation>60 s vor einem Alarm, 20 s danach</translation>
    </message>
    <message>
        <source>Open incident</source>
        <translation>Vorfall öffnen</translation>
    </message>
    <message>
        <source>No alarm has been recorded yet.</source>
        <translation>Es wurde noch kein Alarm aufgezeichnet.</translation>
    </message>
    <message>
        <source>It could not be saved: %1</source>
        <translation>Konnte nicht gespeichert werden: %1</translation>
    </message>
    <message>
        <source>Incident of %1: %2</source>
        <translation>Vorfall vom %1: %2</translation>
    </message>
    <message>
        <source>Paused at %1; recording goes on</source>
        <translation>Angehalten um %1; die Aufzeichnung läuft weiter</translation>
    </message>
    <message>
        <source>Nothing is recorded: no communication</source>
        <translation>Es wird nichts aufgezeichnet: keine Kommunikation</translation>
    </message>
    <message>
        <source>Live; values of %1</source>
        <translation>Live; Werte von %1</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>%1 is refused by the controller.</source>
        <translation>%1 wird von der Steuerung abgelehnt.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>This incident cannot be read: %1</source>
        <translation>Dieser Vorfall kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Export what is in view</source>
        <translation>Sichtbares exportieren</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>Die Datei konnte nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>Letztes rückgängig</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importieren…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>%1 can only be read over HSES.</source>
        <translation>%1 lässt sich über HSES nur lesen.</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Wird geschrieben…</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>%n anwenden…</numerusform>
            <numerusform>%n anwenden…</numerusform>
        </translation>
    </message>
    <message>
        <source>The values are being written.</source>
        <translation>Die Werte werden gerade geschrieben.</translation>
    </message>
    <message>
        <source>Nothing is staged: press Enter in a value.</source>
        <translation>Nichts ist vorgemerkt: Drücken Sie in einem Wert die Eingabetaste.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>Nichts ist vorgemerkt.</translation>
    </message>
    <message>
        <source>Stages the values that stood there before.</source>
        <translation>Merkt die Werte vor, die vorher dort standen.</translation>
    </message>
    <message>
        <source>Nothing was written that could be undone.</source>
        <translation>Es wurde nichts geschrieben, was rückgängig zu machen wäre.</translation>
    </message>
    <message>
        <source>Import values</source>
        <translation>Werte importieren</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>CSV-Dateien (*.csv)</translation>
    </message>
    <message>
        <source>Export values</source>
        <translation>Werte exportieren</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Register</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variablen</translation>
    </message>
    <message>
        <source>%1 stays as it is: %2</source>
        <comment>variable: reason</comment>
        <translation>%1 bleibt, wie es ist: %2</translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message>
        <source>%1 was written.</source>
        <translation>%1 wurde geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>%n Variable wird gelesen…</numerusform>
            <numerusform>%n Variablen werden gelesen…</numerusform>
        </translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Die Datei kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>Die Datei konnte nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariablesPage</name>
    <message>
        <source>Verify…</source>
        <translation>Prüfen…</translation>
    </message>
    <message>
        <source>Compares two variables with the pendant. It only reads.</source>
        <translation>Vergleicht zwei Variablen mit dem Programmierhandgerät. Es wird nur gelesen.</translation>
    </message>
    <message>
        <source>New watch page…</source>
        <translation>Neue Beobachtungsseite…</translation>
    </message>
    <message>
        <source>New watch page</source>
        <translation>Neue Beobachtungsseite</translation>
    </message>
    <message>
        <source>Name of the page</source>
        <translation>Name der Seite</translation>
    </message>
    <message>
        <source>Watch: %1</source>
        <translation>Beobachtung: %1</translation>
    </message>
    <message>
        <source>Delete this watch page</source>
        <translation>Diese Beobachtungsseite löschen</translation>
    </message>
    <message>
        <source>Show on the watch page “%1”</source>
        <translation>Auf der Beobachtungsseite „%1“ zeigen</translation>
    </message>
    <message>
        <source>Take off this watch page</source>
        <translation>Von dieser Beobachtungsseite nehmen</translation>
    </message>
    <message>
        <source>There is no watch page yet.</source>
        <translation>Es gibt noch keine Beobachtungsseite.</translation>
    </message>
    <message>
        <source>Numbering not verified: nothing is written before it was compared with the pendant.</source>
        <translation>Nummerierung nicht geprüft: Vor dem Vergleich mit dem Programmierhandgerät wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>Simulation: number %1 on the network is B000.</source>
        <translation>Simulation: Nummer %1 im Netzwerk ist B000.</translation>
    </message>
    <message>
        <source>Numbering verified %1: number %2 on the network is B000.</source>
        <translation>Nummerierung geprüft %1: Nummer %2 im Netzwerk ist B000.</translation>
    </message>
    <message>
        <source>Kind of variable</source>
        <translation>Art der Variablen</translation>
    </message>
</context>
<context>
    <name>pages::start::RecentTile</name>
    <message>
        <source>no connection noted yet</source>
        <translation>noch keine Verbindung vermerkt</translation>
    </message>
    <message>
        <source>connected today %1</source>
        <comment>the time</comment>
        <translation>heute um %1 verbunden</translation>
    </message>
    <message>
        <source>connected yesterday %1</source>
        <comment>the time</comment>
        <translation>gestern um %1 verbunden</translation>
    </message>
    <message>
        <source>connected %1 %2</source>
        <comment>the date, the time</comment>
        <translation>am %1 um %2 verbunden</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>Mit %1 verbinden</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>Simulation</translation>
    </message>
</context>
<context>
    <name>pages::start::SetupCard</name>
    <message>
        <source>What must be set on the pendant</source>
        <translation>Was am Programmierhandgerät eingestellt sein muss</translation>
    </message>
    <message>
        <source>Menus differ by model and software</source>
        <translation>Menüs unterscheiden sich je nach Modell und Software</translation>
    </message>
    <message>
        <source>To be found</source>
        <translation>Um gefunden zu werden</translation>
    </message>
    <message>
        <source>The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has an IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.</source>
        <translation>Die Ethernet-Server-Funktion (HSES) ist eingeschaltet; bei DX100, DX200 und FS100 ist sie eine Option. Die Steuerung hat eine IPv4-Adresse im Netzwerk dieses Rechners, und keine Firewall dazwischen verwirft UDP %1 und %2.</translation>
    </message>
    <message>
        <source>To take orders</source>
        <translation>Um Befehle anzunehmen</translation>
    </message>
    <message>
        <source>Only for starting, moving, resetting and files, not for reading: %1.</source>
        <translation>Nur zum Starten, Bewegen, Zurücksetzen und für Dateien, nicht zum Lesen: %1.</translation>
    </message>
    <message>
        <source>To select and replace</source>
        <translation>Zum Wählen und Ersetzen</translation>
    </message>
    <message>
        <source>For selecting jobs from here: %1. For replacing files that exist there: %2.</source>
        <translation>Um von hier Jobs zu wählen: %1. Um Dateien zu ersetzen, die dort vorhanden sind: %2.</translation>
    </message>
</context>
<context>
    <name>pendesk</name>
    <message>
        <source>A teach and monitor desk for Yaskawa robot controllers.</source>
        <translation>Ein Platz zum Teachen und Beobachten von Yaskawa-Robotersteuerungen.</translation>
    </message>
    <message>
        <source>Connect to a simulated controller inside the program.</source>
        <translation>Mit einer simulierten Steuerung im Programm verbinden.</translation>
    </message>
    <message>
        <source>light, dark, or auto for the desktop&apos;s choice.</source>
        <translation>light, dark oder auto für die Wahl des Desktops.</translation>
    </message>
    <message>
        <source>Language of the window, as a code such as de; the desktop&apos;s unless told otherwise.</source>
        <translation>Sprache des Fensters als Code wie de; ohne Angabe die des Desktops.</translation>
    </message>
    <message>
        <source>Allow watching, HOLD and servo off alone, whatever the person at the desk tries.</source>
        <translation>Nur Beobachten, HOLD und Servo aus zulassen, was auch immer am Platz versucht wird.</translation>
    </message>
    <message>
        <source>Write pictures of every page to this folder, print the status read, and end.</source>
        <translation>Bilder aller Seiten in diesen Ordner schreiben, den gelesenen Status ausgeben und beenden.</translation>
    </message>
    <message>
        <source>Print when the window was painted and when the first status was live.</source>
        <translation>Ausgeben, wann das Fenster gezeichnet und wann der erste Status live war.</translation>
    </message>
    <message>
        <source>--demo brings its own controller: leave out --host and --profile.</source>
        <translation>--demo bringt seine eigene Steuerung mit: --host und --profile weglassen.</translation>
    </message>
    <message>
        <source>--theme must be light, dark or auto.</source>
        <translation>--theme muss light, dark oder auto sein.</translation>
    </message>
    <message>
        <source>--language must be one of: %1.</source>
        <translation>--language muss eines von diesen sein: %1.</translation>
    </message>
    <message>
        <source>“%1” is not an option.</source>
        <translation>„%1“ ist keine Option.</translation>
    </message>
    <message>
        <source>--pictures needs a folder, and --demo, --host or --profile.</source>
        <translation>--pictures braucht einen Ordner und --demo, --host oder --profile.</translation>
    </message>
    <message>
        <source>Write one picture of all pages, light and dark, in English, German and Japanese, and end.</source>
        <translation>Ein Bild aller Seiten, hell und dunkel, auf Englisch, Deutsch und Japanisch schreiben und beenden.</translation>
    </message>
    <message>
        <source>--contact-sheet needs a file, and --demo, --host or --profile.</source>
        <translation>--contact-sheet braucht eine Datei und --demo, --host oder --profile.</translation>
    </message>
</context>
<context>
    <name>pendesk::Pictures</name>
    <message>
        <source>not everything was read</source>
        <translation>nicht alles wurde gelesen</translation>
    </message>
    <message>
        <source>pendesk: %1 cannot be written.</source>
        <translation>pendesk: %1 kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Executing</source>
        <translation>In Ausführung</translation>
    </message>
    <message>
        <source>Pictures are in %1</source>
        <translation>Die Bilder sind in %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>der Ordner %1 kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>no live controller within 5 s: %1</source>
        <translation>innerhalb von 5 s keine Steuerung live: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>pendesk: %1.</source>
        <translation>pendesk: %1.</translation>
    </message>
</context>
<context>
    <name>pendeskctl</name>
    <message>
        <source>It stopped at %1. As it was it is in %2; “restore” that one with this name puts it back.</source>
        <translation>Angehalten bei %1. Der vorherige Stand liegt in %2; „restore“ von dort mit diesem Namen stellt ihn wieder her.</translation>
    </message>
    <message>
        <source>Delete all but the newest N backups afterwards, never the last good one.</source>
        <translation>Danach alle Sicherungen außer den N neuesten löschen, nie die letzte gute.</translation>
    </message>
    <message>
        <source>Delete backups older than N days afterwards, never the last good one.</source>
        <translation>Danach Sicherungen löschen, die älter als N Tage sind, nie die letzte gute.</translation>
    </message>
    <message>
        <source>Reads all files of the controller into DIR/&lt;controller&gt;/&lt;UTC time&gt;, in BagIt form.</source>
        <translation>Liest alle Dateien der Steuerung nach DIR/&lt;controller&gt;/&lt;UTC time&gt;, in der Form BagIt.</translation>
    </message>
    <message>
        <source>Reads a backup and tells whether it is what was written.</source>
        <translation>Liest eine Sicherung und sagt, ob sie so ist, wie sie geschrieben wurde.</translation>
    </message>
    <message>
        <source>Only print what would be done.</source>
        <translation>Nur ausgeben, was geschehen würde.</translation>
    </message>
    <message>
        <source>The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it.</source>
        <translation>Die Sicherung ist nicht so, wie sie geschrieben wurde; „verify“ sagt, was nicht stimmt. Es wurde nichts damit getan.</translation>
    </message>
    <message>
        <source>“%1” is no file name.</source>
        <translation>„%1“ ist kein Dateiname.</translation>
    </message>
    <message>
        <source>Print for people instead of JSON.</source>
        <translation>Für Menschen lesbar ausgeben statt als JSON.</translation>
    </message>
    <message>
        <source>The request that a reply answers.</source>
        <translation>Die Anfrage, auf die sich eine Antwort bezieht.</translation>
    </message>
    <message>
        <source>The port of the packets: 10040 or 10041.</source>
        <translation>Der Port der Pakete: 10040 oder 10041.</translation>
    </message>
    <message>
        <source>A packet; without any, one a line on stdin.</source>
        <translation>Ein Paket; ohne Angabe je eines pro Zeile von stdin.</translation>
    </message>
    <message>
        <source>A job is running; files are not changed meanwhile.</source>
        <translation>Ein Job läuft; währenddessen werden keine Dateien geändert.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address.</source>
        <translation>Der Name „%1“ hat keine IPv4-Adresse.</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>%1 exists and is left alone; --yes replaces it.</source>
        <translation>%1 ist vorhanden und bleibt unberührt; --yes ersetzt es.</translation>
    </message>
    <message>
        <source>“%1” is no name that a controller takes.</source>
        <translation>„%1“ ist kein Name, den eine Steuerung annimmt.</translation>
    </message>
    <message>
        <source>%1 exists at the controller and is left alone; --replace replaces it.</source>
        <translation>%1 ist auf der Steuerung vorhanden und bleibt unberührt; --replace ersetzt es.</translation>
    </message>
    <message>
        <source>Lists the jobs.</source>
        <translation>Listet die Jobs auf.</translation>
    </message>
    <message>
        <source>The folder for what comes; for rm, for the copies.</source>
        <translation>Der Ordner für das, was kommt; bei rm für die Kopien.</translation>
    </message>
    <message>
        <source>put: replace what the controller has.</source>
        <translation>put: ersetzen, was die Steuerung hat.</translation>
    </message>
    <message>
        <source>Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”.</source>
        <translation>Geben Sie „ls“, „get NAME…“, „put FILE…“ oder „rm NAME…“ an.</translation>
    </message>
    <message>
        <source>read status, job, position and system information</source>
        <translation>Status, Job, Position und Systeminformationen lesen</translation>
    </message>
    <message>
        <source>read model, system software and parameter version</source>
        <translation>Modell, Systemsoftware und Parameterversion lesen</translation>
    </message>
    <message>
        <source>read the active alarms, or a list of the history</source>
        <translation>die anstehenden Alarme oder eine Liste des Verlaufs lesen</translation>
    </message>
    <message>
        <source>read where the robot stands</source>
        <translation>lesen, wo der Roboter steht</translation>
    </message>
    <message>
        <source>list the jobs</source>
        <translation>die Jobs auflisten</translation>
    </message>
    <message>
        <source>read I/O, write a network input</source>
        <translation>E/A lesen, einen Netzwerkeingang schreiben</translation>
    </message>
    <message>
        <source>read and write registers</source>
        <translation>Register lesen und schreiben</translation>
    </message>
    <message>
        <source>read and write variables</source>
        <translation>Variablen lesen und schreiben</translation>
    </message>
    <message>
        <source>list, read, send and delete files</source>
        <translation>Dateien auflisten, lesen, senden und löschen</translation>
    </message>
    <message>
        <source>read all files of a controller into a new backup</source>
        <translation>alle Dateien einer Steuerung in eine neue Sicherung lesen</translation>
    </message>
    <message>
        <source>tell whether a backup is what was written</source>
        <translation>sagen, ob eine Sicherung so ist, wie sie geschrieben wurde</translation>
    </message>
    <message>
        <source>compare two backups, or one with the controller</source>
        <translation>zwei Sicherungen oder eine mit der Steuerung vergleichen</translation>
    </message>
    <message>
        <source>send back what differs from a backup</source>
        <translation>zurücksenden, was von einer Sicherung abweicht</translation>
    </message>
    <message>
        <source>read values again and again</source>
        <translation>Werte immer wieder lesen</translation>
    </message>
    <message>
        <source>take packets given in hex apart</source>
        <translation>hexadezimal angegebene Pakete zerlegen</translation>
    </message>
    <message>
        <source>Usage: pendeskctl VERB [options]</source>
        <translation>Aufruf: pendeskctl VERB [Optionen]</translation>
    </message>
    <message>
        <source>pendeskctl VERB --help tells more.</source>
        <translation>pendeskctl VERB --help sagt mehr.</translation>
    </message>
    <message>
        <source>there is no verb “%1”.</source>
        <translation>es gibt kein Verb „%1“.</translation>
    </message>
    <message>
        <source>%1: the controller has no such row of I/O groups.</source>
        <translation>%1: Eine solche Reihe von E/A-Gruppen hat die Steuerung nicht.</translation>
    </message>
    <message>
        <source>Instance of the first variable on this controller, 0 or 1 (parameter RS022).</source>
        <translation>Instanz der ersten Variable auf dieser Steuerung, 0 oder 1 (Parameter RS022).</translation>
    </message>
    <message>
        <source>Print JSON.</source>
        <translation>JSON ausgeben.</translation>
    </message>
    <message>
        <source>Yes, write: what changes something does nothing without it.</source>
        <translation>Ja, schreiben: Was etwas ändert, tut ohne dies nichts.</translation>
    </message>
    <message>
        <source>No progress and no remarks.</source>
        <translation>Kein Fortschritt und keine Bemerkungen.</translation>
    </message>
    <message>
        <source>--numbering takes 0 or 1.</source>
        <translation>--numbering erwartet 0 oder 1.</translation>
    </message>
    <message>
        <source>Name the controller with --host or --profile.</source>
        <translation>Nennen Sie die Steuerung mit --host oder --profile.</translation>
    </message>
    <message>
        <source>See pendeskctl %1 --help.</source>
        <translation>Siehe pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>This changes something at the controller or on this computer. Add --yes to do it.</source>
        <translation>Das ändert etwas auf der Steuerung oder auf diesem Rechner. Mit --yes wird es ausgeführt.</translation>
    </message>
    <message>
        <source>Say what to read.</source>
        <translation>Geben Sie an, was gelesen werden soll.</translation>
    </message>
    <message>
        <source>Positions are not written from the command line.</source>
        <translation>Positionen werden nicht von der Befehlszeile aus geschrieben.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 lässt sich nicht schreiben.</translation>
    </message>
    <message>
        <source>Nobody has verified which instance a variable has on this controller. Compare one value with the pendant, then say --numbering 0 or --numbering 1.</source>
        <translation>Niemand hat geprüft, welche Instanz eine Variable auf dieser Steuerung hat. Vergleichen Sie einen Wert mit dem Programmierhandgerät, und geben Sie dann --numbering 0 oder --numbering 1 an.</translation>
    </message>
    <message>
        <source>Another value was read back: %1</source>
        <translation>Ein anderer Wert wurde zurückgelesen: %1</translation>
    </message>
    <message>
        <source>io set takes one signal, such as 27010, and 0 or 1.</source>
        <translation>io set erwartet ein Signal, zum Beispiel 27010, und 0 oder 1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: HSES writes network inputs alone.</source>
        <translation>%1 lässt sich nicht schreiben: HSES schreibt nur Netzwerkeingänge.</translation>
    </message>
    <message>
        <source>Say “get NAME…” or “set NAME VALUE”.</source>
        <translation>Geben Sie „get NAME…“ oder „set NAME VALUE“ an.</translation>
    </message>
    <message>
        <source>Reads model, system software and parameter version.</source>
        <translation>Liest Modell, Systemsoftware und Parameterversion.</translation>
    </message>
    <message>
        <source>In pulses instead of the base frame.</source>
        <translation>In Impulsen statt im Basiskoordinatensystem.</translation>
    </message>
    <message>
        <source>A list of the history instead: major, minor, user, system or offline.</source>
        <translation>Stattdessen eine Liste des Verlaufs: major, minor, user, system oder offline.</translation>
    </message>
    <message>
        <source>Reads the active alarms, newest first.</source>
        <translation>Liest die anstehenden Alarme, den neuesten zuerst.</translation>
    </message>
    <message>
        <source>--history takes major, minor, user, system or offline.</source>
        <translation>--history erwartet major, minor, user, system oder offline.</translation>
    </message>
    <message>
        <source>Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input.</source>
        <translation>Liest Reihen von E/A-Gruppen (2701..2710) oder Signale (27010, IN#(1)); schreibt einen Netzwerkeingang.</translation>
    </message>
    <message>
        <source>Reads registers; writes one and reads it back.</source>
        <translation>Liest Register; schreibt eines und liest es zurück.</translation>
    </message>
    <message>
        <source>Reads variables B I D R S P BP EX; writes one and reads it back.</source>
        <translation>Liest Variablen B I D R S P BP EX; schreibt eine und liest sie zurück.</translation>
    </message>
    <message>
        <source>Time between two readings: 1s, 200ms.</source>
        <translation>Zeit zwischen zwei Lesevorgängen: 1s, 200ms.</translation>
    </message>
    <message>
        <source>End after so many readings.</source>
        <translation>Nach so vielen Lesevorgängen enden.</translation>
    </message>
    <message>
        <source>Reads variables, registers (M005) and I/O again and again, one line of JSON with --json.</source>
        <translation>Liest Variablen, Register (M005) und E/A immer wieder, mit --json jeweils eine Zeile JSON.</translation>
    </message>
    <message>
        <source>Reads status, executing job, position and system information once.</source>
        <translation>Liest Status, laufenden Job, Position und Systeminformationen einmal.</translation>
    </message>
    <message>
        <source>Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need --yes.</source>
        <translation>Listet, liest, sendet und löscht Dateien. Gesendete Dateien werden zurückgelesen; bevor eine Datei gelöscht wird, wird hier eine Kopie geschrieben. Vorhandenes wird von get mit --yes und von put mit --replace ersetzt; put und rm brauchen --yes.</translation>
    </message>
    <message>
        <source>The controller lists no file that “%1” matches.</source>
        <translation>Die Steuerung listet keine Datei, auf die „%1“ passt.</translation>
    </message>
    <message>
        <source>The controller is named with --host H, or with --profile NAME as Pendesk keeps it.</source>
        <translation>Die Steuerung wird mit --host H genannt, oder mit --profile NAME, wie Pendesk sie führt.</translation>
    </message>
    <message>
        <source>What changes something does nothing without --yes.</source>
        <translation>Was etwas ändert, tut ohne --yes nichts.</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,
5 local file error, 6 verification failed, 7 done in part.</source>
        <translation>Rückgabewerte: 0 erledigt, 1 Unterschiede, 2 falscher Aufruf, 3 keine Antwort oder Ausgang unbekannt, 4 abgelehnt,
5 lokaler Dateifehler, 6 Prüfung nicht bestanden, 7 teilweise erledigt.</translation>
    </message>
    <message>
        <source>Nobody has verified how this controller numbers its variables (parameter RS022), so these may be their neighbours. --numbering 0 or --numbering 1 settles it.</source>
        <translation>Niemand hat geprüft, wie diese Steuerung ihre Variablen nummeriert (Parameter RS022); dies können also die Nachbarn sein. --numbering 0 oder --numbering 1 legt es fest.</translation>
    </message>
    <message>
        <source>Print this and end.</source>
        <translation>Dies ausgeben und enden.</translation>
    </message>
    <message>
        <source>Files restored: %1. The fresh backup is %2.</source>
        <translation>Wiederhergestellte Dateien: %1. Die frische Sicherung ist %2.</translation>
    </message>
    <message>
        <source>The software of the controller is another than that with which the numbering was verified. Verify it again, or say --numbering 0 or --numbering 1.</source>
        <translation>Die Software der Steuerung ist eine andere als die, mit der die Nummerierung geprüft wurde. Prüfen Sie sie erneut, oder geben Sie --numbering 0 oder --numbering 1 an.</translation>
    </message>
    <message>
        <source>Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.</source>
        <translation>Auch ALL.PRM lesen, das die anderen Parameterdateien wiederholt und eine echte Steuerung 45 s kostet.</translation>
    </message>
    <message>
        <source>The encoding of texts, such as Shift_JIS.</source>
        <translation>Die Kodierung von Texten, etwa Shift_JIS.</translation>
    </message>
    <message>
        <source>Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a controller would refuse one.</source>
        <translation>Prüft Jobs wie vor dem Senden und gibt aus, was falsch oder auffällig ist; Exit-Code 1, wenn eine Steuerung einen ablehnen würde.</translation>
    </message>
    <message>
        <source>Say the files or a folder.</source>
        <translation>Geben Sie die Dateien oder einen Ordner an.</translation>
    </message>
    <message>
        <source>“%1” is no encoding.</source>
        <translation>„%1“ ist keine Kodierung.</translation>
    </message>
    <message>
        <source>Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.</source>
        <translation>Nicht gezählt: %1 Zähler, %2 Protokolle, %3 andere Dateien mit nichts als Daten, Stunden oder Prüfzeilen.</translation>
    </message>
    <message>
        <source>Count dates, counters, logs, blanks and line ends as differences too.</source>
        <translation>Auch Datumsangaben, Zähler, Protokolle, Leerzeichen und Zeilenenden als Unterschiede zählen.</translation>
    </message>
    <message>
        <source>Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if configuration or data differ.</source>
        <translation>Vergleicht zwei Sicherungen oder Ordner mit Dateien der Steuerung, oder eine mit der Steuerung, in Worten; Exit-Code 1, wenn Konfiguration oder Daten abweichen.</translation>
    </message>
    <message>
        <source>The encoding of texts: %1.</source>
        <translation>Die Kodierung von Texten: %1.</translation>
    </message>
    <message>
        <source>The controller model: %1.</source>
        <translation>Das Modell der Steuerung: %1.</translation>
    </message>
    <message>
        <source>look at jobs before they are sent</source>
        <translation>Jobs vor dem Senden prüfen</translation>
    </message>
    <message>
        <source>tell what controller files say</source>
        <translation>sagen, was in Dateien der Steuerung steht</translation>
    </message>
    <message>
        <source>The encoding of the pendant&apos;s language instead of the stored one: %1.</source>
        <translation>Die Kodierung der Sprache des Programmierhandgeräts statt der gespeicherten: %1.</translation>
    </message>
    <message>
        <source>--encoding takes one of %1.</source>
        <translation>--encoding nimmt eines von %1.</translation>
    </message>
    <message>
        <source>--%1 takes a whole number that is not negative.</source>
        <translation>--%1 nimmt eine ganze Zahl, die nicht negativ ist.</translation>
    </message>
    <message>
        <source>%1 does not take “%2”. See pendeskctl %1 --help.</source>
        <translation>%1 nimmt „%2“ nicht an. Siehe pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>%1 takes %2. See pendeskctl %1 --help.</source>
        <translation>%1 nimmt %2. Siehe pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>Reads where a control group stands: the first robot, or R2, B1, S1.</source>
        <translation>Liest, wo eine Achsgruppe steht: der erste Roboter oder R2, B1, S1.</translation>
    </message>
    <message>
        <source>“%1” is no control group of a %2: say R1, B1 or S1.</source>
        <translation>„%1“ ist keine Achsgruppe einer %2: R1, B1 oder S1 angeben.</translation>
    </message>
    <message>
        <source>The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names can be sent by their names.</source>
        <translation>Die Sicherung (links) ist von einem anderen Roboter als die Steuerung (rechts). Es wurde nichts gesendet. Einzelne Jobs und Namen lassen sich unter ihren Namen senden.</translation>
    </message>
    <message>
        <source>Sends back what differs from a backup of the same robot: first a fresh backup beside it, then file by file, each read back. Tools, frames and areas only by name; parameters, calibration and ladder never; never while a job runs.</source>
        <translation>Sendet zurück, was von einer Sicherung desselben Roboters abweicht: zuerst eine frische Sicherung daneben, dann Datei für Datei, jede zurückgelesen. Werkzeuge, Koordinatensysteme und Bereiche nur namentlich; Parameter, Kalibrierung und Kontaktplan (Ladder) nie; nie, während ein Job läuft.</translation>
    </message>
    <message>
        <source>%1 bytes that are not a text.</source>
        <translation>%1 Bytes, die kein Text sind.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>The encoding of the pendant.</source>
        <translation>Die Kodierung des Programmierhandgeräts.</translation>
    </message>
    <message>
        <source>Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. Addresses, users and passwords are masked.</source>
        <translation>Sagt, was in Dateien der Steuerung steht: Namen, Werkzeuge, Koordinatensysteme, Variablen, Parameter, Kontaktplan (Ladder), Protokolle. Adressen, Benutzer und Kennwörter sind verdeckt.</translation>
    </message>
    <message>
        <source>Say a backup, a folder or files.</source>
        <translation>Geben Sie eine Sicherung, einen Ordner oder Dateien an.</translation>
    </message>
    <message>
        <source>There is no encoding “%1”.</source>
        <translation>Es gibt keine Kodierung „%1“.</translation>
    </message>
    <message>
        <source>--every takes a time such as 200ms or 1s.</source>
        <translation>--every nimmt eine Zeit wie 200ms oder 1s.</translation>
    </message>
    <message>
        <source>Another signal of the group changed meanwhile; nothing was sent.</source>
        <translation>Ein anderes Signal der Gruppe hat sich inzwischen geändert; es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>not used in these files</source>
        <translation>in diesen Dateien nicht benutzt</translation>
    </message>
    <message>
        <source>a job that is known when the line runs</source>
        <translation>ein Job, der erst bei Ausführung der Zeile feststeht</translation>
    </message>
    <message>
        <source>no file has it</source>
        <translation>keine Datei enthält ihn</translation>
    </message>
    <message>
        <source>Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in the ladder, in files of names.</source>
        <translation>Nennt, wo Variablen, Signale, Register, Werkzeuge, Koordinatensysteme, Makros, Alarme und Jobs benutzt werden: in Jobs, im Kontaktplan, in Namensdateien.</translation>
    </message>
    <message>
        <source>Say what to look for, such as B012, IN#(5) or a job.</source>
        <translation>Nennen Sie das Gesuchte, etwa B012, IN#(5) oder einen Job.</translation>
    </message>
    <message>
        <source>Tells which job calls, jumps to or starts which, line by line.</source>
        <translation>Nennt Zeile für Zeile, welcher Job welchen aufruft, anspringt oder startet.</translation>
    </message>
    <message>
        <source>Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, variables that are never written, tools that were not entered.</source>
        <translation>Nennt, was einen Blick wert ist: nirgends genannte Jobs, fehlende Jobs, mehrfach geschriebene Ausgänge, nie geschriebene Variablen, nicht eingegebene Werkzeuge.</translation>
    </message>
    <message>
        <source>tell where variables, signals and jobs are used</source>
        <translation>nennen, wo Variablen, Signale und Jobs benutzt werden</translation>
    </message>
    <message>
        <source>tell which job calls which</source>
        <translation>nennen, welcher Job welchen aufruft</translation>
    </message>
    <message>
        <source>tell what in the files is worth a look</source>
        <translation>nennen, was in den Dateien einen Blick wert ist</translation>
    </message>
</context>
<context>
    <name>pendeskctl::AlarmReader</name>
    <message>
        <source>There are no alarms.</source>
        <translation>Es gibt keine Alarme.</translation>
    </message>
</context>
<context>
    <name>pendeskctl::Gap</name>
    <message>
        <source>Answers again after %1 s.</source>
        <translation>Antwortet nach %1 s wieder.</translation>
    </message>
</context>
<context>
    <name>protocol</name>
    <message>
        <source>refused with status %1, which is not in the code list</source>
        <translation>abgelehnt mit Status %1, der nicht in der Codeliste steht</translation>
    </message>
    <message>
        <source>%1 refused, with a code that is not in the code list</source>
        <translation>%1 abgelehnt, mit einem Code, der nicht in der Codeliste steht</translation>
    </message>
    <message>
        <source>the controller did not answer; nothing was changed</source>
        <translation>die Steuerung hat nicht geantwortet; nichts wurde geändert</translation>
    </message>
    <message>
        <source>no answer: it may or may not have happened — look at the robot</source>
        <translation>keine Antwort: Es kann geschehen sein oder auch nicht — nach dem Roboter sehen</translation>
    </message>
    <message>
        <source>the answer does not fit the question</source>
        <translation>die Antwort passt nicht zur Frage</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>nichts wurde gesendet</translation>
    </message>
    <message>
        <source>this computer&apos;s network refused</source>
        <translation>das Netzwerk dieses Rechners hat abgelehnt</translation>
    </message>
    <message>
        <source>this cannot be sent to a controller</source>
        <translation>das kann nicht an eine Steuerung gesendet werden</translation>
    </message>
    <message>
        <source>a file on this computer could not be read or written</source>
        <translation>eine Datei auf diesem Rechner konnte nicht gelesen oder geschrieben werden</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>the command is faulty</source>
        <translation>der Befehl ist fehlerhaft</translation>
    </message>
    <message>
        <source>the command has the wrong number of operands</source>
        <translation>der Befehl hat die falsche Anzahl Operanden</translation>
    </message>
    <message>
        <source>an operand is out of its range</source>
        <translation>ein Operand liegt außerhalb seines Bereichs</translation>
    </message>
    <message>
        <source>an operand has the wrong length</source>
        <translation>ein Operand hat die falsche Länge</translation>
    </message>
    <message>
        <source>the device holds too many files</source>
        <translation>das Speichergerät enthält zu viele Dateien</translation>
    </message>
    <message>
        <source>delete files that are not needed</source>
        <translation>nicht benötigte Dateien löschen</translation>
    </message>
    <message>
        <source>the robot is running</source>
        <translation>der Roboter läuft</translation>
    </message>
    <message>
        <source>wait until it has stopped, or hold it</source>
        <translation>warten, bis er steht, oder ihn mit HOLD anhalten</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>vom Programmierhandgerät gehalten</translation>
    </message>
    <message>
        <source>release HOLD on the pendant</source>
        <translation>HOLD am Programmierhandgerät aufheben</translation>
    </message>
    <message>
        <source>held by the playback panel</source>
        <translation>vom Playback-Bedienfeld gehalten</translation>
    </message>
    <message>
        <source>release HOLD on the panel or pendant</source>
        <translation>HOLD am Bedienfeld oder Programmierhandgerät aufheben</translation>
    </message>
    <message>
        <source>held by an external signal</source>
        <translation>von einem externen Signal gehalten</translation>
    </message>
    <message>
        <source>release the external hold signal</source>
        <translation>das externe Hold-Signal aufheben</translation>
    </message>
    <message>
        <source>held by a command</source>
        <translation>von einem Befehl gehalten</translation>
    </message>
    <message>
        <source>switch HOLD off</source>
        <translation>HOLD ausschalten</translation>
    </message>
    <message>
        <source>an alarm or error is present</source>
        <translation>ein Alarm oder Fehler steht an</translation>
    </message>
    <message>
        <source>remove its cause, then reset the alarm</source>
        <translation>die Ursache beheben, dann den Alarm zurücksetzen</translation>
    </message>
    <message>
        <source>servo power is off</source>
        <translation>die Servoleistung ist aus</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>Servo einschalten</translation>
    </message>
    <message>
        <source>the controller is in the wrong mode</source>
        <translation>die Steuerung ist in der falschen Betriebsart</translation>
    </message>
    <message>
        <source>turn the pendant key to the mode needed, usually PLAY in REMOTE</source>
        <translation>den Schlüsselschalter des Programmierhandgeräts in die nötige Betriebsart drehen, meist PLAY in REMOTE</translation>
    </message>
    <message>
        <source>the files are in use by another function</source>
        <translation>eine andere Funktion benutzt die Dateien</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>gleich noch einmal versuchen</translation>
    </message>
    <message>
        <source>command remote is not enabled</source>
        <translation>CMD REMOTE ist nicht freigegeben</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and enable command remote</source>
        <translation>den Schlüsselschalter des Programmierhandgeräts auf REMOTE drehen und CMD REMOTE freigeben</translation>
    </message>
    <message>
        <source>this data may not be accessed</source>
        <translation>auf diese Daten darf nicht zugegriffen werden</translation>
    </message>
    <message>
        <source>check the security mode and the data protection on the pendant</source>
        <translation>am Programmierhandgerät den Sicherheitsmodus und den Datenschutz prüfen</translation>
    </message>
    <message>
        <source>this data may not be loaded</source>
        <translation>diese Daten dürfen nicht geladen werden</translation>
    </message>
    <message>
        <source>the data is being edited</source>
        <translation>die Daten werden gerade bearbeitet</translation>
    </message>
    <message>
        <source>leave the editor on the pendant</source>
        <translation>den Editor am Programmierhandgerät verlassen</translation>
    </message>
    <message>
        <source>a coordinate conversion is in progress</source>
        <translation>eine Koordinatenumrechnung läuft</translation>
    </message>
    <message>
        <source>try again when it has ended</source>
        <translation>noch einmal versuchen, wenn sie beendet ist</translation>
    </message>
    <message>
        <source>servo power must be on first</source>
        <translation>die Servoleistung muss zuerst eingeschaltet sein</translation>
    </message>
    <message>
        <source>the home position must be set or checked</source>
        <translation>die Home-Position muss gesetzt oder geprüft werden</translation>
    </message>
    <message>
        <source>check the home position on the pendant</source>
        <translation>die Home-Position am Programmierhandgerät prüfen</translation>
    </message>
    <message>
        <source>the position must be checked</source>
        <translation>die Position muss geprüft werden</translation>
    </message>
    <message>
        <source>confirm the position on the pendant</source>
        <translation>die Position am Programmierhandgerät bestätigen</translation>
    </message>
    <message>
        <source>the present position is not available</source>
        <translation>die aktuelle Position ist nicht verfügbar</translation>
    </message>
    <message>
        <source>the panel lock prohibits a change of mode or cycle</source>
        <translation>die Bedienfeldsperre verbietet einen Wechsel von Betriebsart oder Zyklus</translation>
    </message>
    <message>
        <source>release the panel lock</source>
        <translation>die Bedienfeldsperre aufheben</translation>
    </message>
    <message>
        <source>the panel lock prohibits a start</source>
        <translation>die Bedienfeldsperre verbietet einen Start</translation>
    </message>
    <message>
        <source>the user frame is not taught</source>
        <translation>das Benutzerkoordinatensystem ist nicht geteacht</translation>
    </message>
    <message>
        <source>teach the user frame</source>
        <translation>das Benutzerkoordinatensystem teachen</translation>
    </message>
    <message>
        <source>the user frame data is damaged</source>
        <translation>die Daten des Benutzerkoordinatensystems sind beschädigt</translation>
    </message>
    <message>
        <source>teach the user frame again</source>
        <translation>das Benutzerkoordinatensystem neu teachen</translation>
    </message>
    <message>
        <source>the control group is wrong</source>
        <translation>die Achsgruppe ist falsch</translation>
    </message>
    <message>
        <source>choose a control group that this controller has</source>
        <translation>eine Achsgruppe wählen, die diese Steuerung hat</translation>
    </message>
    <message>
        <source>the base axis data is wrong</source>
        <translation>die Daten der Basisachsen sind falsch</translation>
    </message>
    <message>
        <source>a relative job may not be converted</source>
        <translation>ein Relativjob darf nicht umgewandelt werden</translation>
    </message>
    <message>
        <source>permit the conversion on the pendant</source>
        <translation>die Umwandlung am Programmierhandgerät zulassen</translation>
    </message>
    <message>
        <source>a parameter prohibits calling the master job</source>
        <translation>ein Parameter verbietet den Aufruf des Masterjobs</translation>
    </message>
    <message>
        <source>permit the master call on the pendant</source>
        <translation>den Masteraufruf am Programmierhandgerät zulassen</translation>
    </message>
    <message>
        <source>the master job may not be called while operating</source>
        <translation>der Masterjob darf während des Betriebs nicht aufgerufen werden</translation>
    </message>
    <message>
        <source>wait until the operation has ended</source>
        <translation>warten, bis der Betrieb beendet ist</translation>
    </message>
    <message>
        <source>the teach lock prohibits calling the master job</source>
        <translation>die Teach-Sperre verbietet den Aufruf des Masterjobs</translation>
    </message>
    <message>
        <source>release the teach lock</source>
        <translation>die Teach-Sperre aufheben</translation>
    </message>
    <message>
        <source>robot calibration data is missing</source>
        <translation>Daten der Roboterkalibrierung fehlen</translation>
    </message>
    <message>
        <source>calibrate the robots</source>
        <translation>die Roboter kalibrieren</translation>
    </message>
    <message>
        <source>servo power cannot be switched on</source>
        <translation>die Servoleistung lässt sich nicht einschalten</translation>
    </message>
    <message>
        <source>check the safety chain: emergency stop, safeguards, alarms</source>
        <translation>den Sicherheitskreis prüfen: Not-Halt, Schutzeinrichtungen, Alarme</translation>
    </message>
    <message>
        <source>the coordinate system cannot be set</source>
        <translation>das Koordinatensystem kann nicht gesetzt werden</translation>
    </message>
    <message>
        <source>no memory is left for jobs</source>
        <translation>für Jobs ist kein Speicher mehr frei</translation>
    </message>
    <message>
        <source>delete jobs that are not needed</source>
        <translation>nicht benötigte Jobs löschen</translation>
    </message>
    <message>
        <source>no memory is left for position data</source>
        <translation>für Positionsdaten ist kein Speicher mehr frei</translation>
    </message>
    <message>
        <source>editing of this job is prohibited</source>
        <translation>das Bearbeiten dieses Jobs ist verboten</translation>
    </message>
    <message>
        <source>remove the edit lock of the job</source>
        <translation>die Bearbeitungssperre des Jobs aufheben</translation>
    </message>
    <message>
        <source>a job of that name exists</source>
        <translation>ein Job dieses Namens existiert schon</translation>
    </message>
    <message>
        <source>delete or rename it, or permit overwriting</source>
        <translation>ihn löschen oder umbenennen, oder Überschreiben zulassen</translation>
    </message>
    <message>
        <source>the job was not found</source>
        <translation>der Job wurde nicht gefunden</translation>
    </message>
    <message>
        <source>check the job name</source>
        <translation>den Jobnamen prüfen</translation>
    </message>
    <message>
        <source>no job is set for execution</source>
        <translation>kein Job ist zur Ausführung gesetzt</translation>
    </message>
    <message>
        <source>select a job first</source>
        <translation>zuerst einen Job wählen</translation>
    </message>
    <message>
        <source>position data is damaged</source>
        <translation>Positionsdaten sind beschädigt</translation>
    </message>
    <message>
        <source>load the job again from a backup</source>
        <translation>den Job erneut aus einer Sicherung laden</translation>
    </message>
    <message>
        <source>position data is missing</source>
        <translation>Positionsdaten fehlen</translation>
    </message>
    <message>
        <source>teach the missing position</source>
        <translation>die fehlende Position teachen</translation>
    </message>
    <message>
        <source>the position variable has the wrong type</source>
        <translation>die Positionsvariable hat den falschen Typ</translation>
    </message>
    <message>
        <source>write the type that the variable is declared with</source>
        <translation>den Typ schreiben, mit dem die Variable deklariert ist</translation>
    </message>
    <message>
        <source>END was reached in a job that is not the master</source>
        <translation>END wurde in einem Job erreicht, der nicht der Masterjob ist</translation>
    </message>
    <message>
        <source>instruction data is damaged</source>
        <translation>Anweisungsdaten sind beschädigt</translation>
    </message>
    <message>
        <source>the job name has a character that is not allowed</source>
        <translation>der Jobname enthält ein unzulässiges Zeichen</translation>
    </message>
    <message>
        <source>rename the job</source>
        <translation>den Job umbenennen</translation>
    </message>
    <message>
        <source>a label has a character that is not allowed</source>
        <translation>eine Marke enthält ein unzulässiges Zeichen</translation>
    </message>
    <message>
        <source>rename the label</source>
        <translation>die Marke umbenennen</translation>
    </message>
    <message>
        <source>this system does not have the instruction</source>
        <translation>dieses System kennt die Anweisung nicht</translation>
    </message>
    <message>
        <source>the job to convert has no steps</source>
        <translation>der umzuwandelnde Job hat keine Schritte</translation>
    </message>
    <message>
        <source>the job is converted already</source>
        <translation>der Job ist bereits umgewandelt</translation>
    </message>
    <message>
        <source>the user frame must be taught</source>
        <translation>das Benutzerkoordinatensystem muss geteacht werden</translation>
    </message>
    <message>
        <source>relative jobs or independent control are not permitted</source>
        <translation>Relativjobs oder unabhängige Steuerung sind nicht zugelassen</translation>
    </message>
    <message>
        <source>an instruction has a syntax error</source>
        <translation>eine Anweisung hat einen Syntaxfehler</translation>
    </message>
    <message>
        <source>correct the instruction</source>
        <translation>die Anweisung berichtigen</translation>
    </message>
    <message>
        <source>the position data has an error</source>
        <translation>die Positionsdaten haben einen Fehler</translation>
    </message>
    <message>
        <source>correct the position section</source>
        <translation>den Positionsabschnitt berichtigen</translation>
    </message>
    <message>
        <source>NOP or END is missing</source>
        <translation>NOP oder END fehlt</translation>
    </message>
    <message>
        <source>begin the instructions with NOP and end them with END</source>
        <translation>die Anweisungen mit NOP beginnen und mit END beenden</translation>
    </message>
    <message>
        <source>the format is wrong</source>
        <translation>das Format ist falsch</translation>
    </message>
    <message>
        <source>the number of data is wrong</source>
        <translation>die Anzahl der Daten ist falsch</translation>
    </message>
    <message>
        <source>correct the counts in the NPOS line</source>
        <translation>die Anzahlen in der Zeile NPOS berichtigen</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>ein Wert liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>den Wert berichtigen</translation>
    </message>
    <message>
        <source>there is a syntax error outside the instructions</source>
        <translation>außerhalb der Anweisungen ist ein Syntaxfehler</translation>
    </message>
    <message>
        <source>correct the header of the file</source>
        <translation>den Kopf der Datei berichtigen</translation>
    </message>
    <message>
        <source>a pseudo instruction is wrong</source>
        <translation>eine Pseudoanweisung ist falsch</translation>
    </message>
    <message>
        <source>correct the line that starts with slashes</source>
        <translation>die Zeile berichtigen, die mit Schrägstrichen beginnt</translation>
    </message>
    <message>
        <source>a record of a condition file has an error</source>
        <translation>ein Datensatz einer Bedingungsdatei hat einen Fehler</translation>
    </message>
    <message>
        <source>a record of a job has an error</source>
        <translation>ein Datensatz eines Jobs hat einen Fehler</translation>
    </message>
    <message>
        <source>the data comes from a different system</source>
        <translation>die Daten stammen von einem anderen System</translation>
    </message>
    <message>
        <source>the welding type does not match</source>
        <translation>die Schweißart passt nicht</translation>
    </message>
    <message>
        <source>the robot or station is operating</source>
        <translation>der Roboter oder die Station ist in Betrieb</translation>
    </message>
    <message>
        <source>back up when nothing moves</source>
        <translation>sichern, wenn sich nichts bewegt</translation>
    </message>
    <message>
        <source>the device has too little memory</source>
        <translation>das Speichergerät hat zu wenig Speicher</translation>
    </message>
    <message>
        <source>free memory on the device or use a larger one</source>
        <translation>auf dem Speichergerät Platz schaffen oder ein größeres benutzen</translation>
    </message>
    <message>
        <source>the device cannot be accessed</source>
        <translation>auf das Speichergerät kann nicht zugegriffen werden</translation>
    </message>
    <message>
        <source>check that the device is inserted</source>
        <translation>prüfen, ob das Speichergerät eingesteckt ist</translation>
    </message>
    <message>
        <source>a backup was not expected now</source>
        <translation>eine Sicherung wurde jetzt nicht erwartet</translation>
    </message>
    <message>
        <source>the image is larger than the RAM area</source>
        <translation>das Abbild ist größer als der RAM-Bereich</translation>
    </message>
    <message>
        <source>enlarge the RAM area for backups</source>
        <translation>den RAM-Bereich für Sicherungen vergrößern</translation>
    </message>
    <message>
        <source>no memory was reserved at power-on</source>
        <translation>beim Einschalten wurde kein Speicher reserviert</translation>
    </message>
    <message>
        <source>switch the controller off and on</source>
        <translation>die Steuerung aus- und wieder einschalten</translation>
    </message>
    <message>
        <source>the backup file information cannot be accessed</source>
        <translation>auf die Angaben zur Sicherungsdatei kann nicht zugegriffen werden</translation>
    </message>
    <message>
        <source>the old backup could not be removed</source>
        <translation>die alte Sicherung konnte nicht entfernt werden</translation>
    </message>
    <message>
        <source>the backup could not be renamed</source>
        <translation>die Sicherung konnte nicht umbenannt werden</translation>
    </message>
    <message>
        <source>the drive name is too long</source>
        <translation>der Laufwerksname ist zu lang</translation>
    </message>
    <message>
        <source>the device is the wrong one</source>
        <translation>es ist das falsche Speichergerät</translation>
    </message>
    <message>
        <source>set the automatic backup to the RAM disk</source>
        <translation>die automatische Sicherung auf die RAM-Disk einstellen</translation>
    </message>
    <message>
        <source>a system error occurred</source>
        <translation>ein Systemfehler ist aufgetreten</translation>
    </message>
    <message>
        <source>automatic backup is not available</source>
        <translation>automatische Sicherung ist nicht verfügbar</translation>
    </message>
    <message>
        <source>set up automatic backup on the pendant</source>
        <translation>die automatische Sicherung am Programmierhandgerät einrichten</translation>
    </message>
    <message>
        <source>an automatic backup is running</source>
        <translation>eine automatische Sicherung läuft</translation>
    </message>
    <message>
        <source>the controller does not know this command</source>
        <translation>die Steuerung kennt diesen Befehl nicht</translation>
    </message>
    <message>
        <source>the number does not exist on this controller</source>
        <translation>die Nummer gibt es auf dieser Steuerung nicht</translation>
    </message>
    <message>
        <source>check the number and the variable numbering</source>
        <translation>die Nummer und die Variablennummerierung prüfen</translation>
    </message>
    <message>
        <source>the element does not exist on this controller</source>
        <translation>das Element gibt es auf dieser Steuerung nicht</translation>
    </message>
    <message>
        <source>the reply would be too large for the hardware</source>
        <translation>die Antwort wäre für die Hardware zu groß</translation>
    </message>
    <message>
        <source>ask for less at once</source>
        <translation>weniger auf einmal anfragen</translation>
    </message>
    <message>
        <source>the reply would be too large</source>
        <translation>die Antwort wäre zu groß</translation>
    </message>
    <message>
        <source>the position variable is not defined</source>
        <translation>die Positionsvariable ist nicht definiert</translation>
    </message>
    <message>
        <source>teach or write it first</source>
        <translation>sie zuerst teachen oder schreiben</translation>
    </message>
    <message>
        <source>this data may not be used</source>
        <translation>diese Daten dürfen nicht benutzt werden</translation>
    </message>
    <message>
        <source>the size of the request data is wrong</source>
        <translation>die Größe der Anfragedaten ist falsch</translation>
    </message>
    <message>
        <source>the data is not set</source>
        <translation>die Daten sind nicht gesetzt</translation>
    </message>
    <message>
        <source>set it first</source>
        <translation>sie zuerst setzen</translation>
    </message>
    <message>
        <source>the application is not registered</source>
        <translation>die Anwendung ist nicht registriert</translation>
    </message>
    <message>
        <source>the type is not registered</source>
        <translation>der Typ ist nicht registriert</translation>
    </message>
    <message>
        <source>the control group setting is wrong</source>
        <translation>die Einstellung der Achsgruppe ist falsch</translation>
    </message>
    <message>
        <source>name either robots or stations that this controller has</source>
        <translation>entweder Roboter oder Stationen angeben, die diese Steuerung hat</translation>
    </message>
    <message>
        <source>the speed setting is wrong</source>
        <translation>die Einstellung der Geschwindigkeit ist falsch</translation>
    </message>
    <message>
        <source>use percent for joint and mm/s or °/s for straight moves</source>
        <translation>Prozent für Achsbewegungen und mm/s oder °/s für geradlinige Bewegungen benutzen</translation>
    </message>
    <message>
        <source>no speed is given</source>
        <translation>es ist keine Geschwindigkeit angegeben</translation>
    </message>
    <message>
        <source>give a speed above 0</source>
        <translation>eine Geschwindigkeit über 0 angeben</translation>
    </message>
    <message>
        <source>the coordinate system setting is wrong</source>
        <translation>die Einstellung des Koordinatensystems ist falsch</translation>
    </message>
    <message>
        <source>the type or form setting is wrong</source>
        <translation>die Einstellung von Typ oder Stellung ist falsch</translation>
    </message>
    <message>
        <source>the tool number is wrong</source>
        <translation>die Werkzeugnummer ist falsch</translation>
    </message>
    <message>
        <source>use 0 to 63</source>
        <translation>0 bis 63 benutzen</translation>
    </message>
    <message>
        <source>the user frame number is wrong</source>
        <translation>die Nummer des Benutzerkoordinatensystems ist falsch</translation>
    </message>
    <message>
        <source>use 1 to 63 with a user frame, else 0</source>
        <translation>mit einem Benutzerkoordinatensystem 1 bis 63 benutzen, sonst 0</translation>
    </message>
    <message>
        <source>internal error of the controller: data area</source>
        <translation>interner Fehler der Steuerung: Datenbereich</translation>
    </message>
    <message>
        <source>internal error of the controller: reply area exceeded</source>
        <translation>interner Fehler der Steuerung: Antwortbereich überschritten</translation>
    </message>
    <message>
        <source>internal error of the controller: element size mismatch</source>
        <translation>interner Fehler der Steuerung: Elementgröße stimmt nicht überein</translation>
    </message>
    <message>
        <source>internal error of the controller: customised function</source>
        <translation>interner Fehler der Steuerung: kundenspezifische Funktion</translation>
    </message>
    <message>
        <source>another error</source>
        <translation>ein anderer Fehler</translation>
    </message>
    <message>
        <source>busy with another command</source>
        <translation>mit einem anderen Befehl beschäftigt</translation>
    </message>
    <message>
        <source>another access is in progress</source>
        <translation>ein anderer Zugriff läuft</translation>
    </message>
    <message>
        <source>the backup parameter setting is wrong</source>
        <translation>die Einstellung der Sicherungsparameter ist falsch</translation>
    </message>
    <message>
        <source>the backup file was not created</source>
        <translation>die Sicherungsdatei wurde nicht angelegt</translation>
    </message>
    <message>
        <source>check that the controller is in remote mode</source>
        <translation>prüfen, ob die Steuerung in REMOTE ist</translation>
    </message>
    <message>
        <source>internal system error of the controller</source>
        <translation>interner Systemfehler der Steuerung</translation>
    </message>
    <message>
        <source>the transfer was dropped: nothing came in time</source>
        <translation>die Übertragung wurde abgebrochen: Es kam nicht rechtzeitig etwas an</translation>
    </message>
    <message>
        <source>start the transfer again</source>
        <translation>die Übertragung erneut starten</translation>
    </message>
    <message>
        <source>the file cannot be overwritten</source>
        <translation>die Datei kann nicht überschrieben werden</translation>
    </message>
    <message>
        <source>permit overwriting, or delete the file first</source>
        <translation>Überschreiben zulassen oder die Datei zuerst löschen</translation>
    </message>
    <message>
        <source>the file is missing or empty</source>
        <translation>die Datei fehlt oder ist leer</translation>
    </message>
    <message>
        <source>check the file name</source>
        <translation>den Dateinamen prüfen</translation>
    </message>
    <message>
        <source>the path is wrong</source>
        <translation>der Pfad ist falsch</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>den Pfad prüfen</translation>
    </message>
    <message>
        <source>the file is not in the list</source>
        <translation>die Datei ist nicht in der Liste</translation>
    </message>
    <message>
        <source>the file may not be deleted</source>
        <translation>die Datei darf nicht gelöscht werden</translation>
    </message>
    <message>
        <source>the directory may not be deleted</source>
        <translation>das Verzeichnis darf nicht gelöscht werden</translation>
    </message>
    <message>
        <source>files cannot be accessed while remote is off</source>
        <translation>auf Dateien kann nicht zugegriffen werden, solange REMOTE aus ist</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>die Datei wurde nicht gefunden</translation>
    </message>
    <message>
        <source>the path is too long</source>
        <translation>der Pfad ist zu lang</translation>
    </message>
    <message>
        <source>use a shorter name</source>
        <translation>einen kürzeren Namen benutzen</translation>
    </message>
    <message>
        <source>packet without data</source>
        <translation>Paket ohne Daten</translation>
    </message>
    <message>
        <source>packet too large</source>
        <translation>Paket zu groß</translation>
    </message>
    <message>
        <source>packet of size 0</source>
        <translation>Paket der Größe 0</translation>
    </message>
    <message>
        <source>packet with a wrong block number</source>
        <translation>Paket mit falscher Blocknummer</translation>
    </message>
    <message>
        <source>packet with a wrong ACK byte</source>
        <translation>Paket mit falschem ACK-Byte</translation>
    </message>
    <message>
        <source>packet of a wrong division</source>
        <translation>Paket des falschen Verarbeitungsbereichs</translation>
    </message>
    <message>
        <source>check that robot and file port are not exchanged</source>
        <translation>prüfen, ob Roboter- und Dateiport vertauscht sind</translation>
    </message>
    <message>
        <source>packet with a wrong access level</source>
        <translation>Paket mit falscher Zugriffsebene</translation>
    </message>
    <message>
        <source>packet with a wrong header size</source>
        <translation>Paket mit falscher Kopfgröße</translation>
    </message>
    <message>
        <source>packet with a wrong identifier</source>
        <translation>Paket mit falscher Kennung</translation>
    </message>
    <message>
        <source>announced and received packet sizes differ</source>
        <translation>angekündigte und empfangene Paketgröße stimmen nicht überein</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>zu viele Anfragen</translation>
    </message>
    <message>
        <source>ask less often, or try again in a moment</source>
        <translation>seltener anfragen oder gleich noch einmal versuchen</translation>
    </message>
    <message>
        <source>the mode was changed and the communication dropped</source>
        <translation>die Betriebsart wurde gewechselt und die Kommunikation abgebrochen</translation>
    </message>
    <message>
        <source>start again in the new mode</source>
        <translation>in der neuen Betriebsart neu beginnen</translation>
    </message>
</context>
<context>
    <name>robot::Controller</name>
    <message>
        <source>The name %1 is not known to this computer.</source>
        <translation>Der Name %1 ist diesem Rechner nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>robot::Diagnosis</name>
    <message>
        <source>Host name</source>
        <translation>Hostname</translation>
    </message>
    <message>
        <source>Way to the host</source>
        <translation>Weg zum Host</translation>
    </message>
    <message>
        <source>Robot port</source>
        <translation>Roboterport</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>Systeminformationen</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Dateiport</translation>
    </message>
    <message>
        <source>Not looked at, because the step before it failed.</source>
        <translation>Nicht geprüft, weil der Schritt davor fehlgeschlagen ist.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address on this computer.</source>
        <translation>Der Name „%1“ hat auf diesem Rechner keine IPv4-Adresse.</translation>
    </message>
    <message>
        <source>Check the spelling, or enter the controller&apos;s IPv4 address as the pendant shows it.</source>
        <translation>Prüfen Sie die Schreibweise, oder geben Sie die IPv4-Adresse der Steuerung so ein, wie das Programmierhandgerät sie zeigt.</translation>
    </message>
    <message>
        <source>%1 is %2.</source>
        <translation>%1 ist %2.</translation>
    </message>
    <message>
        <source>This computer cannot send to %1: %2.</source>
        <translation>Dieser Rechner kann nicht an %1 senden: %2.</translation>
    </message>
    <message>
        <source>Check the cable and this computer&apos;s IPv4 address: it must be in the controller&apos;s network.</source>
        <translation>Prüfen Sie das Kabel und die IPv4-Adresse dieses Rechners: Sie muss im Netzwerk der Steuerung liegen.</translation>
    </message>
    <message>
        <source>This computer can send to %1.</source>
        <translation>Dieser Rechner kann an %1 senden.</translation>
    </message>
    <message>
        <source>Port %1 answers with a status.</source>
        <translation>Port %1 antwortet mit einem Status.</translation>
    </message>
    <message>
        <source>Port %1 answers but refuses to tell the status: %2</source>
        <translation>Port %1 antwortet, verweigert aber den Status: %2</translation>
    </message>
    <message>
        <source>Check on the pendant that the network function server is enabled for this computer.</source>
        <translation>Prüfen Sie am Programmierhandgerät, ob der Netzwerkfunktionsserver für diesen Rechner freigegeben ist.</translation>
    </message>
    <message>
        <source>Answers come from another address than %1; they are ignored.</source>
        <translation>Antworten kommen von einer anderen Adresse als %1; sie werden nicht beachtet.</translation>
    </message>
    <message>
        <source>Look for a second network card or an address translation between this computer and the controller.</source>
        <translation>Suchen Sie nach einer zweiten Netzwerkkarte oder einer Adressumsetzung zwischen diesem Rechner und der Steuerung.</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not with HSES.</source>
        <translation>An Port %1 antwortet etwas, aber nicht mit HSES.</translation>
    </message>
    <message>
        <source>Check the address and the port: HSES is UDP %1 on a controller.</source>
        <translation>Prüfen Sie die Adresse und den Port: HSES ist auf einer Steuerung UDP %1.</translation>
    </message>
    <message>
        <source>The host rejects port %1: %2.</source>
        <translation>Der Host weist Port %1 zurück: %2.</translation>
    </message>
    <message>
        <source>The host is there, but no HSES server: enable the Ethernet server function on the controller.</source>
        <translation>Der Host ist da, aber kein HSES-Server: Schalten Sie die Ethernet-Server-Funktion an der Steuerung ein.</translation>
    </message>
    <message>
        <source>Port %1 stays silent.</source>
        <translation>Port %1 bleibt stumm.</translation>
    </message>
    <message>
        <source>Check that the controller is on, that its Ethernet server function is enabled and that no firewall drops UDP %1.</source>
        <translation>Prüfen Sie, ob die Steuerung eingeschaltet ist, ob ihre Ethernet-Server-Funktion freigegeben ist und ob keine Firewall UDP %1 verwirft.</translation>
    </message>
    <message>
        <source>The controller runs %1.</source>
        <translation>Auf der Steuerung läuft %1.</translation>
    </message>
    <message>
        <source>The controller does not tell its system information: %1</source>
        <translation>Die Steuerung nennt ihre Systeminformationen nicht: %1</translation>
    </message>
    <message>
        <source>Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option.</source>
        <translation>Pendesk beobachtet nur eine Steuerung, die sagt, was sie ist. Fragen Sie ihren Hersteller nach der Option HSES.</translation>
    </message>
    <message>
        <source>Port %1 stays silent: files are unavailable, monitoring works.</source>
        <translation>Port %1 bleibt stumm: Dateien sind nicht verfügbar, Beobachten funktioniert.</translation>
    </message>
    <message>
        <source>Check that no firewall drops UDP %1.</source>
        <translation>Prüfen Sie, ob keine Firewall UDP %1 verwirft.</translation>
    </message>
    <message>
        <source>Port %1 answers.</source>
        <translation>Port %1 antwortet.</translation>
    </message>
</context>
<context>
    <name>session::FileSession</name>
    <message>
        <source>An empty file cannot be sent over HSES.</source>
        <translation>Eine leere Datei kann nicht über HSES gesendet werden.</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1 muss eine ganze Zahl von %2 bis %3 sein.</translation>
    </message>
    <message>
        <source>The model “%1” is not known.</source>
        <translation>Das Modell „%1“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The text encoding “%1” is not known.</source>
        <translation>Die Textkodierung „%1“ ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The variable numbering must be 0 or 1.</source>
        <translation>Die Variablennummerierung muss 0 oder 1 sein.</translation>
    </message>
    <message>
        <source>Pulses per degree must be lists of numbers, one list for each control group.</source>
        <translation>Impulse pro Grad müssen Listen von Zahlen sein, eine Liste für jede Achsgruppe.</translation>
    </message>
    <message>
        <source>The profile needs a name.</source>
        <translation>Das Profil braucht einen Namen.</translation>
    </message>
    <message>
        <source>The profile needs the controller&apos;s host name or IPv4 address.</source>
        <translation>Das Profil braucht den Hostnamen oder die IPv4-Adresse der Steuerung.</translation>
    </message>
</context>
<context>
    <name>settings::CommandLine</name>
    <message>
        <source>--%1 must be a whole number from 1 to 65535.</source>
        <translation>--%1 muss eine ganze Zahl von 1 bis 65535 sein.</translation>
    </message>
    <message>
        <source>--timeout takes a time such as 300ms or 1s.</source>
        <translation>--timeout erwartet eine Zeit wie 300ms oder 1s.</translation>
    </message>
    <message>
        <source>There is no controller stored under the name “%1”.</source>
        <translation>Unter dem Namen „%1“ ist keine Steuerung gespeichert.</translation>
    </message>
    <message>
        <source>Connect to the controller with this name or IPv4 address.</source>
        <translation>Mit der Steuerung dieses Namens oder dieser IPv4-Adresse verbinden.</translation>
    </message>
    <message>
        <source>Its port for robot control, 10040 unless told otherwise.</source>
        <translation>Port der Steuerung für Roboterbefehle, ohne Angabe 10040.</translation>
    </message>
    <message>
        <source>Its port for file control, 10041 unless told otherwise.</source>
        <translation>Port der Steuerung für Dateien, ohne Angabe 10041.</translation>
    </message>
    <message>
        <source>Connect to the controller that is stored under this name.</source>
        <translation>Mit der Steuerung verbinden, die unter diesem Namen gespeichert ist.</translation>
    </message>
    <message>
        <source>How long to wait for one try of a read: 300ms, 1s.</source>
        <translation>Wie lange auf einen Leseversuch gewartet wird: 300ms, 1s.</translation>
    </message>
    <message>
        <source>--%1 needs --host or --profile.</source>
        <translation>--%1 braucht --host oder --profile.</translation>
    </message>
    <message>
        <source>--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>--model muss dx100, dx200, fs100, yrc1000 oder yrc1000micro sein.</translation>
    </message>
    <message>
        <source>Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>Ihr Modell: dx100, dx200, fs100, yrc1000 oder yrc1000micro.</translation>
    </message>
    <message>
        <source>What to log, as &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</source>
        <translation>Was protokolliert wird, etwa &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</translation>
    </message>
</context>
<context>
    <name>settings::Profile</name>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Dateiport</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>Zeitlimit Lesen</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>Zeitlimit Dateien</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>Zeitlimit Servo</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>Wiederholungen beim Lesen</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>Gleichzeitig offene Anfragen</translation>
    </message>
    <message>
        <source>Requests a second</source>
        <translation>Anfragen pro Sekunde</translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message>
        <source>The last good ones, of %1, are used.</source>
        <translation>Die letzten guten, vom %1, werden benutzt.</translation>
    </message>
    <message>
        <source>There is no good copy of them.</source>
        <translation>Es gibt keine gute Kopie von ihnen.</translation>
    </message>
    <message>
        <source>The settings in %1 are gone.</source>
        <translation>Die Einstellungen in %1 sind weg.</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1.</source>
        <translation>Die Einstellungen können nicht gelesen werden: %1.</translation>
    </message>
    <message>
        <source>The settings are damaged; they are kept as %1.</source>
        <translation>Die Einstellungen sind beschädigt; sie werden als %1 aufbewahrt.</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>ein anderes Programm hält %1</translation>
    </message>
    <message>
        <source>Settings could not be saved in time and are lost: %1</source>
        <translation>Einstellungen ließen sich nicht rechtzeitig speichern und sind verloren: %1</translation>
    </message>
    <message>
        <source>Settings cannot be saved: %1. Work goes on; it is tried again.</source>
        <translation>Einstellungen sind nicht speicherbar: %1. Die Arbeit geht weiter; neuer Versuch folgt.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>%n Eintrag der früheren Einstellungen kann nicht gelesen werden; er bleibt in %1.</numerusform>
            <numerusform>%n Einträge der früheren Einstellungen können nicht gelesen werden; sie bleiben in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>station::Fleet</name>
    <message>
        <source>%1: %2</source>
        <comment>controller: sentence</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>station::Station</name>
    <message numerus="yes">
        <source>%n staged value(s) were not applied.</source>
        <translation>
            <numerusform>%n vorgemerkter Wert wurde nicht angewendet.</numerusform>
            <numerusform>%n vorgemerkte Werte wurden nicht angewendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are still being transferred.</source>
        <translation>Es werden noch Dateien übertragen.</translation>
    </message>
    <message>
        <source>Files are still being read or sent for a backup, a comparison or a restore.</source>
        <translation>Es werden noch Dateien für eine Sicherung, einen Vergleich oder ein Zurückspielen gelesen oder gesendet.</translation>
    </message>
</context>
<context>
    <name>trend</name>
    <message>
        <source>Alarm %1 [%2] %3</source>
        <translation>Alarm %1 [%2] %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Job %1</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>Schrittbetrieb</translation>
    </message>
    <message>
        <source>One cycle</source>
        <translation>Ein Zyklus</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Dauerlauf</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Geschwindigkeitsgrenze</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>PLAY</source>
        <translation>PLAY</translation>
    </message>
    <message>
        <source>REMOTE</source>
        <translation>REMOTE</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>Vom Programmierhandgerät gehalten</translation>
    </message>
    <message>
        <source>Held externally</source>
        <translation>Extern gehalten</translation>
    </message>
    <message>
        <source>Held by command</source>
        <translation>Durch Befehl gehalten</translation>
    </message>
    <message>
        <source>Alarm active</source>
        <translation>Alarm steht an</translation>
    </message>
    <message>
        <source>Error active</source>
        <translation>Fehler steht an</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ein</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Jobzeile</translation>
    </message>
    <message>
        <source>Job step</source>
        <translation>Jobschritt</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Geschwindigkeits-Override</translation>
    </message>
    <message>
        <source>%1, sub task %2</source>
        <translation>%1, Subtask %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 following error</source>
        <translation>%1 %2 Schleppfehler</translation>
    </message>
    <message>
        <source>%1 %2 torque</source>
        <translation>%1 %2 Drehmoment</translation>
    </message>
    <message>
        <source>%1 %2 encoder temperature</source>
        <translation>%1 %2 Gebertemperatur</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>Impulse</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°C</source>
        <translation>°C</translation>
    </message>
    <message>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <source>Converter temperature, board %1</source>
        <translation>Umrichtertemperatur, Platine %1</translation>
    </message>
    <message>
        <source>Running time %1</source>
        <translation>Laufzeit %1</translation>
    </message>
    <message>
        <source>Alarm code %1</source>
        <translation>Alarmcode %1</translation>
    </message>
</context>
<context>
    <name>trend::Recorder</name>
    <message>
        <source>An incident is lost: %1 could not be written in time.</source>
        <translation>Ein Vorfall ist verloren: %1 konnte nicht rechtzeitig geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message>
        <source>Passcode and idle time…</source>
        <translation>Kennwort und Ruhezeit…</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>Zugriffsstufe: %1</translation>
    </message>
    <message>
        <source>This program was started with --monitor-only: it watches and holds.</source>
        <translation>Dieses Programm wurde mit --monitor-only gestartet: Es beobachtet und kann HOLD senden.</translation>
    </message>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>Was von hier aus getan werden darf. Nach %n Minute ohne Tastatur oder Maus fällt es auf Beobachten zurück.</numerusform>
            <numerusform>Was von hier aus getan werden darf. Nach %n Minuten ohne Tastatur oder Maus fällt es auf Beobachten zurück.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Announcer</name>
    <message>
        <source>New alarm %1: %2</source>
        <translation>Neuer Alarm %1: %2</translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message>
        <source>This controller is armed: press to disarm.</source>
        <translation>Diese Steuerung ist scharf: zum Unscharfschalten drücken.</translation>
    </message>
    <message>
        <source>ARMED · %1 s</source>
        <translation>SCHARF · %1 s</translation>
    </message>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>Noch %n Sekunde scharf. Zum Unscharfschalten drücken.</numerusform>
            <numerusform>Noch %n Sekunden scharf. Zum Unscharfschalten drücken.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message>
        <source>No backup</source>
        <translation>Keine Sicherung</translation>
    </message>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>Sicherung %n Stunde alt</numerusform>
            <numerusform>Sicherung %n Stunden alt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>Sicherung %n Tag alt</numerusform>
            <numerusform>Sicherung %n Tage alt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>Alte Sicherung: %n Tag</numerusform>
            <numerusform>Alte Sicherung: %n Tage</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ControllerView</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>HLOCK is on at %1: the pendant is locked out, but for its emergency stop.</source>
        <translation>HLOCK ist an %1 eingeschaltet: Das Programmierhandgerät ist gesperrt, außer seinem Not-Halt.</translation>
    </message>
    <message>
        <source>Release HLOCK</source>
        <translation>HLOCK aufheben</translation>
    </message>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>Das Journal funktioniert wieder. %n Eintrag ging verloren.</numerusform>
            <numerusform>Das Journal funktioniert wieder. %n Einträge gingen verloren.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal was damaged. It was kept as %1, and a new one was begun.</source>
        <translation>Das Journal war beschädigt. Es wurde als %1 aufbewahrt, und ein neues wurde begonnen.</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Level: %1</source>
        <translation>Stufe: %1</translation>
    </message>
    <message>
        <source>HLOCK is on</source>
        <translation>HLOCK ist eingeschaltet</translation>
    </message>
    <message>
        <source>Pendesk</source>
        <translation>Pendesk</translation>
    </message>
    <message>
        <source>%1 — Pendesk</source>
        <translation>%1 — Pendesk</translation>
    </message>
    <message>
        <source>The demo could not be started: %1.</source>
        <translation>Die Demo konnte nicht gestartet werden: %1.</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Über Pendesk</translation>
    </message>
    <message>
        <source>Pendesk %1

A teach and monitor desk for Yaskawa robot controllers.
Free software under the GNU General Public License, version 3 or later.

HOLD is a software hold over the network, not a safety function.</source>
        <translation>Pendesk %1

Ein Platz zum Teachen und Beobachten von Yaskawa-Robotersteuerungen.
Freie Software unter der GNU General Public License, Version 3 oder neuer.

HOLD ist ein Softwarehalt über das Netzwerk und keine Sicherheitsfunktion.</translation>
    </message>
    <message>
        <source>There is no connection.</source>
        <translation>Es besteht keine Verbindung.</translation>
    </message>
    <message>
        <source>The connection is open.</source>
        <translation>Die Verbindung ist offen.</translation>
    </message>
    <message>
        <source>No controller is chosen.</source>
        <translation>Keine Steuerung ist gewählt.</translation>
    </message>
    <message>
        <source>No controller is chosen: connect first.</source>
        <translation>Keine Steuerung ist gewählt: bitte zuerst verbinden.</translation>
    </message>
    <message>
        <source>%1 requests/s</source>
        <translation>%1 Anfragen/s</translation>
    </message>
    <message>
        <source>Something is unfinished</source>
        <translation>Etwas ist noch nicht fertig</translation>
    </message>
    <message>
        <source>Go on and lose it</source>
        <translation>Fortfahren und verwerfen</translation>
    </message>
    <message>
        <source>HLOCK is still on at %1: the pendant stays locked out if you go on.</source>
        <translation>HLOCK ist an %1 noch ein: Das Programmierhandgerät bleibt gesperrt, wenn Sie fortfahren.</translation>
    </message>
    <message>
        <source>Release HLOCK and go on</source>
        <translation>HLOCK aufheben und fortfahren</translation>
    </message>
    <message>
        <source>Go on and leave it on</source>
        <translation>Fortfahren und eingeschaltet lassen</translation>
    </message>
</context>
<context>
    <name>ui::NavigationRail</name>
    <message>
        <source>CONTROLLERS</source>
        <translation>STEUERUNGEN</translation>
    </message>
    <message>
        <source>PAGES</source>
        <translation>SEITEN</translation>
    </message>
    <message>
        <source>CONNECTION</source>
        <translation>VERBINDUNG</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
</context>
<context>
    <name>ui::RobotStrip</name>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>Keine Steuerung</translation>
    </message>
    <message>
        <source>Link · %1 ago</source>
        <translation>Verbindung · vor %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>VERLOREN</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>wird geprüft…</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Job · %1</source>
        <translation>Job · %1</translation>
    </message>
</context>
<context>
    <name>ui::StationList</name>
    <message numerus="yes">
        <source>%n more in Fleet</source>
        <translation>
            <numerusform>%n weitere in „Flotte“</numerusform>
            <numerusform>%n weitere in „Flotte“</numerusform>
        </translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>Keine Steuerung</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
</context>
<context>
    <name>values</name>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 Bit</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>conveyor files</source>
        <translation>Förderband-Dateien</translation>
    </message>
    <message>
        <source>robots and stations</source>
        <translation>Roboter und Stationen</translation>
    </message>
    <message>
        <source>signed number</source>
        <translation>Zahl mit Vorzeichen</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>robots, stations and bases</source>
        <translation>Roboter, Stationen und Basisachsen</translation>
    </message>
    <message>
        <source>control group, low and high axes</source>
        <translation>Achsgruppe, untere und obere Achsen</translation>
    </message>
    <message>
        <source>control group, minimum and maximum axes</source>
        <translation>Achsgruppe, minimale und maximale Achsen</translation>
    </message>
    <message>
        <source>control group, minimum and maximum X Y Z</source>
        <translation>Achsgruppe, minimale und maximale X Y Z</translation>
    </message>
    <message>
        <source>axes of two control groups</source>
        <translation>Achsen zweier Achsgruppen</translation>
    </message>
    <message>
        <source>two sets of axes of a control group</source>
        <translation>zwei Sätze Achsen einer Achsgruppe</translation>
    </message>
    <message>
        <source>axes of a control group and a number</source>
        <translation>Achsen einer Achsgruppe und eine Zahl</translation>
    </message>
    <message>
        <source>control group and a number</source>
        <translation>Achsgruppe und eine Zahl</translation>
    </message>
    <message>
        <source>unknown type %1</source>
        <translation>unbekannter Typ %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>Arm oben</translation>
    </message>
    <message>
        <source>lower arm</source>
        <translation>Arm unten</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>Flip</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>kein Flip</translation>
    </message>
    <message>
        <source>R &lt; 180</source>
        <translation>R &lt; 180</translation>
    </message>
    <message>
        <source>R &gt;= 180</source>
        <translation>R &gt;= 180</translation>
    </message>
    <message>
        <source>T &lt; 180</source>
        <translation>T &lt; 180</translation>
    </message>
    <message>
        <source>T &gt;= 180</source>
        <translation>T &gt;= 180</translation>
    </message>
    <message>
        <source>S &lt; 180</source>
        <translation>S &lt; 180</translation>
    </message>
    <message>
        <source>S &gt;= 180</source>
        <translation>S &gt;= 180</translation>
    </message>
    <message>
        <source>redundant front</source>
        <translation>redundant vorn</translation>
    </message>
    <message>
        <source>redundant back</source>
        <translation>redundant hinten</translation>
    </message>
    <message>
        <source>previous step&apos;s form</source>
        <translation>Stellung des vorigen Schritts</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>diese Stellung</translation>
    </message>
    <message>
        <source>L &lt; 180</source>
        <translation>L &lt; 180</translation>
    </message>
    <message>
        <source>L &gt;= 180</source>
        <translation>L &gt;= 180</translation>
    </message>
    <message>
        <source>U &lt; 180</source>
        <translation>U &lt; 180</translation>
    </message>
    <message>
        <source>U &gt;= 180</source>
        <translation>U &gt;= 180</translation>
    </message>
    <message>
        <source>B &lt; 180</source>
        <translation>B &lt; 180</translation>
    </message>
    <message>
        <source>B &gt;= 180</source>
        <translation>B &gt;= 180</translation>
    </message>
    <message>
        <source>E &lt; 180</source>
        <translation>E &lt; 180</translation>
    </message>
    <message>
        <source>E &gt;= 180</source>
        <translation>E &gt;= 180</translation>
    </message>
    <message>
        <source>W &lt; 180</source>
        <translation>W &lt; 180</translation>
    </message>
    <message>
        <source>W &gt;= 180</source>
        <translation>W &gt;= 180</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>base frame</source>
        <translation>Basiskoordinatensystem</translation>
    </message>
    <message>
        <source>robot frame</source>
        <translation>Roboterkoordinatensystem</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>Benutzerkoordinatensystem</translation>
    </message>
    <message>
        <source>tool frame</source>
        <translation>Werkzeugkoordinatensystem</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>Gruppe %1</translation>
    </message>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>… (%n weiteres Zeichen)</numerusform>
            <numerusform>… (%n weitere Zeichen)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message>
        <source>Line %1: a cell begins with a quotation mark and does not end with one.</source>
        <translation>Zeile %1: Eine Zelle beginnt mit einem Anführungszeichen und endet nicht mit einem.</translation>
    </message>
    <message>
        <source>Line %1: there is text behind the quotation mark that ends a cell.</source>
        <translation>Zeile %1: Hinter dem Anführungszeichen, das eine Zelle beendet, steht Text.</translation>
    </message>
    <message>
        <source>The file is not UTF-8: save it as “CSV UTF-8” and try again.</source>
        <translation>Die Datei ist nicht in UTF-8: Speichern Sie sie als „CSV UTF-8“, und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from %2 to %3.</source>
        <translation>%1 liegt außerhalb des Bereichs: Zulässig ist %2 bis %3.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number: write it without decimals and separators.</source>
        <translation>„%1“ ist keine ganze Zahl: Schreiben Sie sie ohne Nachkommastellen und Trennzeichen.</translation>
    </message>
    <message>
        <source>%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.</source>
        <translation>%1 passt nicht in eine Realzahl: Das ist 0 oder ±1.18e-38 bis ±3.40e+38.</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>„%1“ ist keine ganze Zahl.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>„%1“ ist zu fein: %n Nachkommastelle bleibt erhalten.</numerusform>
            <numerusform>„%1“ ist zu fein: %n Nachkommastellen bleiben erhalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is not a variable. Write its letter and its number, such as B007.</source>
        <translation>„%1“ ist keine Variable. Schreiben Sie ihren Buchstaben und ihre Nummer, zum Beispiel B007.</translation>
    </message>
    <message>
        <source>There is no %1: this controller has %2 to %3.</source>
        <translation>%1 gibt es nicht: Diese Steuerung hat %2 bis %3.</translation>
    </message>
    <message>
        <source>“%1” is not a range: it must go from a lower to a higher number of one kind.</source>
        <translation>„%1“ ist kein Bereich: Er muss von einer niedrigeren zu einer höheren Nummer derselben Art gehen.</translation>
    </message>
    <message>
        <source>“%1” is not a type that %2 has.</source>
        <translation>„%1“ ist kein Typ, den %2 hat.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>column: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing, and no value of this type was read.</source>
        <translation>%1 fehlt, und es wurde kein Wert dieses Typs gelesen.</translation>
    </message>
    <message>
        <source>The type is missing, and none was read.</source>
        <translation>Der Typ fehlt, und es wurde keiner gelesen.</translation>
    </message>
    <message>
        <source>The variable is missing.</source>
        <translation>Die Variable fehlt.</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1 lässt sich nur lesen.</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already.</source>
        <translation>%1 steht schon in Zeile %2.</translation>
    </message>
    <message>
        <source>The value is missing.</source>
        <translation>Der Wert fehlt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>variable: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The column “%1” stands there twice.</source>
        <translation>Die Spalte „%1“ ist zweimal vorhanden.</translation>
    </message>
    <message>
        <source>The header is missing: the first line must name the columns “variable” and “value”.</source>
        <translation>Der Kopf fehlt: Die erste Zeile muss die Spalten „variable“ und „value“ nennen.</translation>
    </message>
    <message>
        <source>There is neither a column “value” nor “axis 1”.</source>
        <translation>Es gibt weder eine Spalte „value“ noch „axis 1“.</translation>
    </message>
    <message>
        <source>The line has more cells than the header.</source>
        <translation>Die Zeile hat mehr Zellen als der Kopf.</translation>
    </message>
    <message>
        <source>A block without a header has one or two columns.</source>
        <translation>Ein Block ohne Kopf hat eine oder zwei Spalten.</translation>
    </message>
    <message>
        <source>The text cannot be sent: %1.</source>
        <translation>Der Text kann nicht gesendet werden: %1.</translation>
    </message>
    <message>
        <source>The text must not hold the character NUL, which ends it.</source>
        <translation>Der Text darf das Zeichen NUL nicht enthalten, das ihn beendet.</translation>
    </message>
    <message>
        <source>The text takes %1 bytes; there is room for %2.</source>
        <translation>Der Text braucht %1 Byte; Platz ist für %2.</translation>
    </message>
    <message>
        <source>A position is not written as one text.</source>
        <translation>Eine Position wird nicht als ein Text geschrieben.</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>eine Realzahl</translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>bis zu %n Byte</numerusform>
            <numerusform>bis zu %n Byte</numerusform>
        </translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>Impuls</translation>
    </message>
</context>
<context>
    <name>widgets::ArmControl</name>
    <message>
        <source>Hold for 1 s to arm</source>
        <translation>1 s gedrückt halten zum Scharfschalten</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>Warum nicht?</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Unscharf schalten</translation>
    </message>
    <message>
        <source>Nobody is inside the fence</source>
        <translation>Niemand ist innerhalb des Schutzzauns</translation>
    </message>
    <message>
        <source>I see the robot, or somebody who does</source>
        <translation>Ich sehe den Roboter, oder jemand anderes sieht ihn</translation>
    </message>
    <message>
        <source>An emergency stop is within reach there</source>
        <translation>Ein Not-Halt ist dort in Reichweite</translation>
    </message>
    <message>
        <source>Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.</source>
        <translation>Scharf: Start, Servo ein und Bewegungen sind möglich. Ohne Tastatur oder Maus endet das nach einer Minute.</translation>
    </message>
    <message>
        <source>Disarmed at %1: %2.</source>
        <translation>Unscharf seit %1: %2.</translation>
    </message>
    <message>
        <source>Tick all three first.</source>
        <translation>Haken Sie zuerst alle drei ab.</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
</context>
<context>
    <name>widgets::CellEditor</name>
    <message>
        <source>live: %1</source>
        <translation>live: %1</translation>
    </message>
</context>
<context>
    <name>widgets::ConditionList</name>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::ControllerTile</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
</context>
<context>
    <name>widgets::DiffView</name>
    <message>
        <source>Lines of both versions</source>
        <translation>Zeilen beider Fassungen</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>Älter</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>Neuer</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::GoToEdit</name>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Go to…  Ctrl+G</source>
        <translation>Gehe zu…  Strg+G</translation>
    </message>
</context>
<context>
    <name>widgets::HoldButton</name>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (Software)</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>Softwarehalt · Pause-Taste</translation>
    </message>
</context>
<context>
    <name>widgets::JobView</name>
    <message>
        <source>Job text</source>
        <translation>Jobtext</translation>
    </message>
</context>
<context>
    <name>widgets::JogPad</name>
    <message>
        <source>Jog %1 forward</source>
        <translation>Tippbetrieb %1 vorwärts</translation>
    </message>
    <message>
        <source>Jog %1 back</source>
        <translation>Tippbetrieb %1 rückwärts</translation>
    </message>
</context>
<context>
    <name>widgets::LogicStrip</name>
    <message>
        <source>The watched signals over the last minute</source>
        <translation>Die beobachteten Signale der letzten Minute</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>−%1 s</source>
        <translation>−%1 s</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>widgets::OrderButton</name>
    <message>
        <source>Why not?</source>
        <translation>Warum nicht?</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Conditions of: %1</source>
        <translation>Bedingungen für: %1</translation>
    </message>
    <message>
        <source>Pending…</source>
        <translation>Ausstehend…</translation>
    </message>
</context>
<context>
    <name>widgets::Plot</name>
    <message>
        <source>seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Nothing is plotted.</source>
        <translation>Keine Kurve gewählt.</translation>
    </message>
</context>
<context>
    <name>widgets::Plottables</name>
    <message>
        <source>Add to trend: %1</source>
        <translation>Zum Trend hinzufügen: %1</translation>
    </message>
</context>
<context>
    <name>widgets::Question</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>widgets::Rows</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::Segments</name>
    <message>
        <source>%1: %2</source>
        <comment>what is chosen: the choice</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>widgets::Sparkline</name>
    <message>
        <source>Round trips of the last 60 seconds: none yet.</source>
        <translation>Umlaufzeiten der letzten 60 Sekunden: noch keine.</translation>
    </message>
    <message>
        <source>Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.</source>
        <translation>Umlaufzeiten der letzten 60 Sekunden: längste %1 ms, verlorene Versuche in %2 s.</translation>
    </message>
</context>
<context>
    <name>widgets::ToolPathView</name>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Tool path, %1 view</source>
        <translation>Werkzeugbahn, Ansicht %1</translation>
    </message>
    <message>
        <source>No position in the base frame was read yet.</source>
        <translation>Es wurde noch keine Position im Basiskoordinatensystem gelesen.</translation>
    </message>
    <message>
        <source>%1 %2 mm, %3 %4 mm. %5</source>
        <translation>%1 %2 mm, %3 %4 mm. %5</translation>
    </message>
    <message>
        <source>%1  ·  %2 →  %3 ↑</source>
        <translation>%1  ·  %2 →  %3 ↑</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>widgets::ValueGrid</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>widgets::ValueLabel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
</TS>
