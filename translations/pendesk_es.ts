<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES">
<context>
    <name>Actions</name>
    <message>
        <source> or </source>
        <translation> o </translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (software)</translation>
    </message>
    <message>
        <source>Access level…</source>
        <translation>Nivel de acceso…</translation>
    </message>
    <message>
        <source>Open this page in its own window</source>
        <translation>Abrir esta página en su propia ventana</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Conectar…</translation>
    </message>
    <message>
        <source>Connect to this controller</source>
        <translation>Conectar con este controlador</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Abrir la demo</translation>
    </message>
    <message>
        <source>Diagnose…</source>
        <translation>Diagnóstico…</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>Copiar diagnóstico</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Acerca de Pendesk</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Language and look…</source>
        <translation>Idioma y aspecto…</translation>
    </message>
    <message>
        <source>Readiness…</source>
        <translation>Disponibilidad…</translation>
    </message>
    <message>
        <source>Help and shortcuts</source>
        <translation>Ayuda y atajos</translation>
    </message>
</context>
<context>
    <name>Alarms</name>
    <message>
        <source>Major</source>
        <translation>Mayor</translation>
    </message>
    <message>
        <source>Minor</source>
        <translation>Menor</translation>
    </message>
    <message>
        <source>User, system</source>
        <translation>Usuario, sistema</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>Off-line</source>
        <translation>Fuera de línea</translation>
    </message>
    <message>
        <source>◆ unacknowledged</source>
        <translation>◆ sin reconocer</translation>
    </message>
    <message>
        <source>■ acknowledged</source>
        <translation>■ reconocida</translation>
    </message>
    <message>
        <source>▲ cleared, unacknowledged</source>
        <translation>▲ eliminada, sin reconocer</translation>
    </message>
    <message>
        <source>□ cleared</source>
        <translation>□ eliminada</translation>
    </message>
    <message>
        <source>No sub code.</source>
        <translation>Sin subcódigo.</translation>
    </message>
    <message>
        <source>%1: %2. As sent: %3, type %4.</source>
        <translation>%1: %2. Tal como se envió: %3, tipo %4.</translation>
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
        <translation>cumplida</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>no cumplida</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>aún no leída</translation>
    </message>
    <message>
        <source>cannot be read over HSES</source>
        <translation>no se puede leer por HSES</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what was tried: how it ended</comment>
        <translation>%1: %2.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armar</translation>
    </message>
    <message>
        <source>Reset alarm</source>
        <translation>Restablecer alarma</translation>
    </message>
    <message>
        <source>Cancel error</source>
        <translation>Cancelar error</translation>
    </message>
    <message>
        <source>Write a signal</source>
        <translation>Escribir una señal</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>Escribir un registro</translation>
    </message>
    <message>
        <source>Write a variable</source>
        <translation>Escribir una variable</translation>
    </message>
    <message>
        <source>Select a job</source>
        <translation>Seleccionar un trabajo</translation>
    </message>
    <message>
        <source>Select a master job</source>
        <translation>Seleccionar un trabajo maestro</translation>
    </message>
    <message>
        <source>Start the job</source>
        <translation>Iniciar el trabajo</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (software)</translation>
    </message>
    <message>
        <source>Release HOLD</source>
        <translation>Liberar HOLD</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ON</translation>
    </message>
    <message>
        <source>Servo off</source>
        <translation>Servo OFF</translation>
    </message>
    <message>
        <source>HLOCK on</source>
        <translation>HLOCK ON</translation>
    </message>
    <message>
        <source>HLOCK off</source>
        <translation>HLOCK OFF</translation>
    </message>
    <message>
        <source>Select the cycle mode</source>
        <translation>Seleccionar el modo de ciclo</translation>
    </message>
    <message>
        <source>Show a message on the pendant</source>
        <translation>Mostrar un mensaje en la consola de programación</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Movimiento manual</translation>
    </message>
    <message>
        <source>Send a file to the controller</source>
        <translation>Enviar un archivo al controlador</translation>
    </message>
    <message>
        <source>Get a file from the controller</source>
        <translation>Obtener un archivo del controlador</translation>
    </message>
    <message>
        <source>Delete a file on the controller</source>
        <translation>Borrar un archivo del controlador</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Restaurar una copia de seguridad</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Supervisión</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Operación</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Ingeniería</translation>
    </message>
    <message>
        <source>disarmed by hand</source>
        <translation>desarmado a mano</translation>
    </message>
    <message>
        <source>nobody used key or mouse for a minute</source>
        <translation>nadie usó el teclado ni el ratón durante un minuto</translation>
    </message>
    <message>
        <source>another program came to the front</source>
        <translation>otro programa pasó al primer plano</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>se bloqueó la pantalla</translation>
    </message>
    <message>
        <source>communication was lost</source>
        <translation>se perdió la comunicación</translation>
    </message>
    <message>
        <source>the mode changed at the controller</source>
        <translation>el modo cambió en el controlador</translation>
    </message>
    <message>
        <source>an alarm came up</source>
        <translation>se produjo una alarma</translation>
    </message>
    <message>
        <source>the access level fell back</source>
        <translation>el nivel de acceso volvió atrás</translation>
    </message>
    <message>
        <source>another window came to the front</source>
        <translation>otra ventana pasó al primer plano</translation>
    </message>
    <message>
        <source>another controller was armed</source>
        <translation>se armó otro controlador</translation>
    </message>
    <message>
        <source>The link to the controller is up</source>
        <translation>El enlace con el controlador está activo</translation>
    </message>
    <message>
        <source>The access level is Operate or Engineer</source>
        <translation>El nivel de acceso es Operación o Ingeniería</translation>
    </message>
    <message>
        <source>The access level is Engineer</source>
        <translation>El nivel de acceso es Ingeniería</translation>
    </message>
    <message>
        <source>The status is fresh</source>
        <translation>El estado está actualizado</translation>
    </message>
    <message>
        <source>This controller is armed</source>
        <translation>Este controlador está armado</translation>
    </message>
    <message>
        <source>REMOTE is on</source>
        <translation>REMOTE está activado</translation>
    </message>
    <message>
        <source>The mode is PLAY</source>
        <translation>El modo es PLAY</translation>
    </message>
    <message>
        <source>The mode is not TEACH</source>
        <translation>El modo no es TEACH</translation>
    </message>
    <message>
        <source>There is no alarm</source>
        <translation>No hay ninguna alarma</translation>
    </message>
    <message>
        <source>There is no error</source>
        <translation>No hay ningún error</translation>
    </message>
    <message>
        <source>Not held by the pendant</source>
        <translation>Sin HOLD por la consola de programación</translation>
    </message>
    <message>
        <source>Not held by an external signal</source>
        <translation>Sin HOLD por una señal externa</translation>
    </message>
    <message>
        <source>Not held by a command</source>
        <translation>Sin HOLD por un comando</translation>
    </message>
    <message>
        <source>Held by a command</source>
        <translation>En HOLD por un comando</translation>
    </message>
    <message>
        <source>Servo power is on</source>
        <translation>La alimentación de servos está conectada</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>No hay ningún trabajo en marcha</translation>
    </message>
    <message>
        <source>A job is selected</source>
        <translation>Hay un trabajo seleccionado</translation>
    </message>
    <message>
        <source>The numbering of variables is verified</source>
        <translation>La numeración de variables está verificada</translation>
    </message>
    <message>
        <source>The model takes move orders</source>
        <translation>El modelo admite órdenes de movimiento</translation>
    </message>
    <message>
        <source>The safety circuit is closed</source>
        <translation>El circuito de seguridad está cerrado</translation>
    </message>
    <message>
        <source>Not held by a playback panel</source>
        <translation>Sin HOLD por un panel de reproducción</translation>
    </message>
    <message>
        <source>Home position and position check are confirmed</source>
        <translation>La posición de origen y la comprobación de posición están confirmadas</translation>
    </message>
    <message>
        <source>Starting is not locked at the panel</source>
        <translation>El inicio no está bloqueado en el panel</translation>
    </message>
    <message>
        <source>Mode and cycle are not locked at the panel</source>
        <translation>El modo y el ciclo no están bloqueados en el panel</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is permitted</source>
        <translation>Se permite seleccionar un trabajo en REMOTE y PLAY</translation>
    </message>
    <message>
        <source>Changing the master job is permitted</source>
        <translation>Se permite cambiar el trabajo maestro</translation>
    </message>
    <message>
        <source>The job exists on the controller</source>
        <translation>El trabajo existe en el controlador</translation>
    </message>
    <message>
        <source>Nothing is being edited at the pendant</source>
        <translation>No se está editando nada en la consola de programación</translation>
    </message>
    <message>
        <source>No other function uses the files</source>
        <translation>Ninguna otra función utiliza los archivos</translation>
    </message>
    <message>
        <source>The data are not protected</source>
        <translation>Los datos no están protegidos</translation>
    </message>
    <message>
        <source>Replacing existing files is permitted</source>
        <translation>Se permite reemplazar archivos existentes</translation>
    </message>
    <message>
        <source>There is no link to the controller</source>
        <translation>No hay enlace con el controlador</translation>
    </message>
    <message>
        <source>connect, or wait until it answers again</source>
        <translation>conéctese o espere a que vuelva a responder</translation>
    </message>
    <message>
        <source>The access level is Monitor</source>
        <translation>El nivel de acceso es Supervisión</translation>
    </message>
    <message>
        <source>switch to Operate in the strip (Ctrl+L)</source>
        <translation>cambie a Operación en la barra (Ctrl+L)</translation>
    </message>
    <message>
        <source>The access level is not Engineer</source>
        <translation>El nivel de acceso no es Ingeniería</translation>
    </message>
    <message>
        <source>switch to Engineer in the strip (Ctrl+L)</source>
        <translation>cambie a Ingeniería en la barra (Ctrl+L)</translation>
    </message>
    <message>
        <source>The status was not read just now</source>
        <translation>El estado no se ha leído recientemente</translation>
    </message>
    <message>
        <source>wait a moment; if it stays so, look at the link</source>
        <translation>espere un momento; si sigue así, compruebe el enlace</translation>
    </message>
    <message>
        <source>This controller is not armed</source>
        <translation>Este controlador no está armado</translation>
    </message>
    <message>
        <source>arm it on this page</source>
        <translation>ármelo en esta página</translation>
    </message>
    <message>
        <source>REMOTE is off</source>
        <translation>REMOTE está desactivado</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1</source>
        <translation>gire la llave de la consola de programación a REMOTE y active CMD REMOTE SEL: %1</translation>
    </message>
    <message>
        <source>The mode is not PLAY</source>
        <translation>El modo no es PLAY</translation>
    </message>
    <message>
        <source>turn the pendant key to PLAY or REMOTE</source>
        <translation>gire la llave de la consola de programación a PLAY o REMOTE</translation>
    </message>
    <message>
        <source>The controller is in TEACH</source>
        <translation>El controlador está en TEACH</translation>
    </message>
    <message>
        <source>the person at the pendant has the robot: turn the key to REMOTE when that is over</source>
        <translation>la persona que está en la consola de programación tiene el mando del robot: gire la llave a REMOTE cuando haya terminado</translation>
    </message>
    <message>
        <source>There is an alarm</source>
        <translation>Hay una alarma</translation>
    </message>
    <message>
        <source>remove its cause, then reset it on the Alarms page</source>
        <translation>elimine su causa y después restablézcala en la página Alarmas</translation>
    </message>
    <message>
        <source>There is an error</source>
        <translation>Hay un error</translation>
    </message>
    <message>
        <source>read it on the Alarms page, then cancel it</source>
        <translation>léalo en la página Alarmas y después cancélelo</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>En HOLD por la consola de programación</translation>
    </message>
    <message>
        <source>release it there</source>
        <translation>libérelo allí</translation>
    </message>
    <message>
        <source>Held by an external signal</source>
        <translation>En HOLD por una señal externa</translation>
    </message>
    <message>
        <source>release it where that signal comes from</source>
        <translation>libérelo donde se origina esa señal</translation>
    </message>
    <message>
        <source>release HOLD on the Jobs page</source>
        <translation>libere HOLD en la página Trabajos</translation>
    </message>
    <message>
        <source>No command holds the robot</source>
        <translation>Ningún comando retiene el robot</translation>
    </message>
    <message>
        <source>there is nothing to release from here</source>
        <translation>no hay nada que liberar desde aquí</translation>
    </message>
    <message>
        <source>Servo power is off</source>
        <translation>La alimentación de servos está desconectada</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>active Servo ON</translation>
    </message>
    <message>
        <source>A job is running</source>
        <translation>Hay un trabajo en marcha</translation>
    </message>
    <message>
        <source>wait until it has ended, or hold it</source>
        <translation>espere a que termine o deténgalo con HOLD</translation>
    </message>
    <message>
        <source>No job is selected</source>
        <translation>No hay ningún trabajo seleccionado</translation>
    </message>
    <message>
        <source>select one on the Jobs page</source>
        <translation>seleccione uno en la página Trabajos</translation>
    </message>
    <message>
        <source>The numbering of variables is not verified</source>
        <translation>La numeración de variables no está verificada</translation>
    </message>
    <message>
        <source>compare two variables with the pendant (Variables page)</source>
        <translation>compare dos variables con la consola de programación (página Variables)</translation>
    </message>
    <message>
        <source>This model takes no move orders</source>
        <translation>Este modelo no admite órdenes de movimiento</translation>
    </message>
    <message>
        <source>move it with the pendant</source>
        <translation>muévalo con la consola de programación</translation>
    </message>
    <message>
        <source>The safety circuit is open</source>
        <translation>El circuito de seguridad está abierto</translation>
    </message>
    <message>
        <source>look at emergency stops, doors and the enabling switch</source>
        <translation>compruebe las paradas de emergencia, las puertas y el interruptor de habilitación</translation>
    </message>
    <message>
        <source>Held by a playback panel</source>
        <translation>En HOLD por un panel de reproducción</translation>
    </message>
    <message>
        <source>Home position or position check is missing</source>
        <translation>Falta la posición de origen o la comprobación de posición</translation>
    </message>
    <message>
        <source>confirm the position at the pendant</source>
        <translation>confirme la posición en la consola de programación</translation>
    </message>
    <message>
        <source>Starting is locked at the panel</source>
        <translation>El inicio está bloqueado en el panel</translation>
    </message>
    <message>
        <source>release the start lock (I/O or panel prohibit) at the cell</source>
        <translation>libere el bloqueo de inicio (E/S o prohibición del panel) en la celda</translation>
    </message>
    <message>
        <source>Mode and cycle are locked at the panel</source>
        <translation>El modo y el ciclo están bloqueados en el panel</translation>
    </message>
    <message>
        <source>release the panel lock (I/O or panel prohibit) at the cell</source>
        <translation>libere el bloqueo del panel (E/S o prohibición del panel) en la celda</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is prohibited</source>
        <translation>Está prohibido seleccionar un trabajo en REMOTE y PLAY</translation>
    </message>
    <message>
        <source>set “job select when remote and play” to permit: %1</source>
        <translation>ajuste “job select when remote and play” a permitir: %1</translation>
    </message>
    <message>
        <source>Changing the master job is prohibited</source>
        <translation>Está prohibido cambiar el trabajo maestro</translation>
    </message>
    <message>
        <source>permit it at the pendant (master call, teach lock): %1</source>
        <translation>permítalo en la consola de programación (llamada al trabajo maestro, bloqueo de enseñanza): %1</translation>
    </message>
    <message>
        <source>The job is not on the controller</source>
        <translation>El trabajo no está en el controlador</translation>
    </message>
    <message>
        <source>read the list of jobs again</source>
        <translation>lea de nuevo la lista de trabajos</translation>
    </message>
    <message>
        <source>Something is being edited at the pendant</source>
        <translation>Se está editando algo en la consola de programación</translation>
    </message>
    <message>
        <source>leave the editor there</source>
        <translation>salga allí del editor</translation>
    </message>
    <message>
        <source>Another function uses the files</source>
        <translation>Otra función utiliza los archivos</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>inténtelo de nuevo en un momento</translation>
    </message>
    <message>
        <source>The data are protected</source>
        <translation>Los datos están protegidos</translation>
    </message>
    <message>
        <source>release the protection at the pendant</source>
        <translation>libere la protección en la consola de programación</translation>
    </message>
    <message>
        <source>Replacing files is not permitted</source>
        <translation>No se permite reemplazar archivos</translation>
    </message>
    <message>
        <source>set the parameters RS029 and RS214 to 1: %1</source>
        <translation>ajuste los parámetros RS029 y RS214 a 1: %1</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION COND. o FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or TEACHING COND.</source>
        <translation>SETUP, FUNCTION COND. o TEACHING COND.</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE or TEACHING COND.</source>
        <translation>SETUP, FUNCTION ENABLE o TEACHING COND.</translation>
    </message>
    <message>
        <source>PARAMETER, RS (management mode)</source>
        <translation>PARAMETER, RS (modo de administración)</translation>
    </message>
    <message>
        <source>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)</source>
        <translation>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 en un DX100)</translation>
    </message>
    <message>
        <source>The controller shows an error</source>
        <translation>El controlador indica un error</translation>
    </message>
    <message>
        <source>The controller shows no error</source>
        <translation>El controlador no indica ningún error</translation>
    </message>
    <message>
        <source>there is nothing to cancel</source>
        <translation>no hay nada que cancelar</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>se cerró la conexión</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>se cambió el idioma</translation>
    </message>
    <message>
        <source>the window was turned to another controller</source>
        <translation>la ventana pasó a otro controlador</translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation>el equipo entró en suspensión</translation>
    </message>
    <message>
        <source>this program stood still, or the computer&apos;s clock jumped</source>
        <translation>este programa estuvo parado o el reloj del equipo dio un salto</translation>
    </message>
</context>
<context>
    <name>FileSheet</name>
    <message>
        <source>There is no “%1”.</source>
        <translation>No existe “%1”.</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>No existe la carpeta “%1”.</translation>
    </message>
    <message>
        <source>“%1” exists already. Is it to be replaced?</source>
        <translation>“%1” ya existe. ¿Desea reemplazarlo?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>LinkView</name>
    <message>
        <source>checking</source>
        <translation>comprobando</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en vivo</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>comunicación perdida</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>no conectado</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Diagnose…</source>
        <translation>Diagnóstico…</translation>
    </message>
    <message>
        <source>HOLD not confirmed: use the pendant.</source>
        <translation>HOLD no confirmado: utilice la consola de programación.</translation>
    </message>
    <message>
        <source>HOLD was refused: %1. Use the pendant.</source>
        <translation>HOLD fue rechazado: %1. Utilice la consola de programación.</translation>
    </message>
    <message>
        <source>No contact with %1 yet: %2. Checking goes on by itself.</source>
        <translation>Aún no hay contacto con %1: %2. La comprobación continúa por sí sola.</translation>
    </message>
    <message>
        <source>Checking %1: waiting for system information and status.</source>
        <translation>Comprobando %1: a la espera de la información del sistema y del estado.</translation>
    </message>
    <message>
        <source>Communication lost at %1 — showing the last values read. Reading resumes by itself.</source>
        <translation>Comunicación perdida a las %1 — se muestran los últimos valores leídos. La lectura se reanuda por sí sola.</translation>
    </message>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>Comunicación restablecida a las %1. Perdida %n vez desde la conexión.</numerusform>
            <numerusform>Comunicación restablecida a las %1. Perdida %n veces desde la conexión.</numerusform>
        </translation>
    </message>
    <message>
        <source>HOLD was not sent: there is no connection to a controller. Use the pendant.</source>
        <translation>HOLD no se envió: no hay conexión con ningún controlador. Utilice la consola de programación.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Conectar…</translation>
    </message>
</context>
<context>
    <name>Noise</name>
    <message>
        <source>Date of the last change of a job (///DATE)</source>
        <translation>Fecha de la última modificación de un trabajo (///DATE)</translation>
    </message>
    <message>
        <source>Dates and times of day, such as 2026/01/31 08:30</source>
        <translation>Fechas y horas, por ejemplo 2026/01/31 08:30</translation>
    </message>
    <message>
        <source>Operating time counters, such as 18:19&apos;02</source>
        <translation>Contadores de tiempo de funcionamiento, por ejemplo 18:19&apos;02</translation>
    </message>
    <message>
        <source>Blanks at the end of a line</source>
        <translation>Espacios al final de una línea</translation>
    </message>
    <message>
        <source>Line ends: CR LF or LF, and whether the last line has one</source>
        <translation>Fines de línea: CR LF o LF, y si la última línea tiene uno</translation>
    </message>
</context>
<context>
    <name>OrderRecords</name>
    <message>
        <source>✓ done</source>
        <translation>✓ hecho</translation>
    </message>
    <message>
        <source>✗ refused</source>
        <translation>✗ rechazado</translation>
    </message>
    <message>
        <source>▲ unknown</source>
        <translation>▲ desconocido</translation>
    </message>
    <message>
        <source>□ not sent</source>
        <translation>□ no enviado</translation>
    </message>
    <message>
        <source>□ cancelled</source>
        <translation>□ cancelado</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>kept on this computer</source>
        <translation>guardado en este equipo</translation>
    </message>
    <message>
        <source>the last values read before %1</source>
        <translation>los últimos valores leídos antes de %1</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Overview</source>
        <translation>Vista general</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Registros</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>Movimiento manual y desplazamiento</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Tendencia</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Trabajos</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Copia de seguridad</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Diario</translation>
    </message>
    <message>
        <source>The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works.</source>
        <translation>El estado del robot de un vistazo: modo, ciclo, servo, marcha, las tres causas de HOLD, alarma, error y límite de velocidad, el trabajo en ejecución, la posición de R1 y la calidad del enlace.</translation>
    </message>
    <message>
        <source>“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it.</source>
        <translation>“¿Qué puedo hacer ahora?” enumera lo que se puede ordenar. ✓ se puede intentar; ✗ no, con el primer motivo al lado.</translation>
    </message>
    <message>
        <source>Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲.</source>
        <translation>Los bits que se contradicen, como TEACH y PLAY, se muestran uno junto al otro tal como se recibieron, bajo ▲.</translation>
    </message>
    <message>
        <source>Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend.</source>
        <translation>Copiar, junto a la información del sistema, lleva el modelo y el software al portapapeles. El botón derecho del ratón sobre un número lo añade a la tendencia.</translation>
    </message>
    <message>
        <source>Up to four active alarms, the newest first, and the past alarms that were read from the controller.</source>
        <translation>Hasta cuatro alarmas activas, la más reciente primero, y las alarmas anteriores que se leyeron del controlador.</translation>
    </message>
    <message>
        <source>Acknowledge is noted on this computer only: the robot does not hear of it.</source>
        <translation>Reconocer se anota solo en este equipo: al robot no se le comunica.</translation>
    </message>
    <message>
        <source>Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there.</source>
        <translation>Restablecer alarma y Cancelar error son órdenes: necesitan REMOTE y el nivel Operación, e indican antes qué restablecen o cancelan. Tras un restablecimiento aceptado, una alarma puede permanecer: en ese caso su causa sigue presente.</translation>
    </message>
    <message>
        <source>Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes.</source>
        <translation>Leer ahora obtiene el historial y lo conserva en el diario, incluso después de que el controlador lo haya descartado. Más frecuentes cuenta los códigos.</translation>
    </message>
    <message>
        <source>Notes keep what caused a code and what was done, on this computer.</source>
        <translation>Las notas guardan en este equipo qué causó un código y qué se hizo.</translation>
    </message>
    <message>
        <source>All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds.</source>
        <translation>Todas las señales de un área, un grupo de ocho por fila. Un cuadrado relleno es 1, uno hueco es 0; un marco señala lo que cambió en los dos últimos segundos.</translation>
    </message>
    <message>
        <source>Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together.</source>
        <translation>Por HSES solo se pueden escribir las entradas de red, y se necesita el nivel Ingeniería. Una escritura lee el grupo, cambia un bit, muestra el valor anterior y el nuevo, y vuelve a leer: los ocho bits viajan juntos.</translation>
    </message>
    <message>
        <source>Names come from the controller&apos;s IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch.</source>
        <translation>Los nombres proceden del archivo IONAME.DAT del controlador. El botón derecho del ratón permite dar aquí nombre a una señal o ponerla en la pestaña Vigilar.</translation>
    </message>
    <message>
        <source>Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen.</source>
        <translation>Vigilar cuenta los flancos y dibuja el último minuto. Lee cuatro veces por segundo: los impulsos más cortos no se ven.</translation>
    </message>
    <message>
        <source>Go to takes #27010 as well as IN#(1).</source>
        <translation>Ir a admite tanto #27010 como IN#(1).</translation>
    </message>
    <message>
        <source>The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read.</source>
        <translation>Los registros de M000 a M999, como números decimales, con signo, hexadecimales o binarios. Solo se leen las filas visibles.</translation>
    </message>
    <message>
        <source>M000 to M559 can be written by an engineer; the others belong to the ladder.</source>
        <translation>De M000 a M559 se pueden escribir con el nivel Ingeniería; los demás pertenecen al programa de escalera (ladder).</translation>
    </message>
    <message>
        <source>Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back.</source>
        <translation>Intro en el editor prepara un valor: pasa a color ámbar y no se envía nada. Aplicar muestra el valor anterior y el nuevo de todos los valores preparados, escribe cada uno una vez y lo vuelve a leer.</translation>
    </message>
    <message>
        <source>A value that reads back differently is red and stays. Undo last stages the values from before the last Apply.</source>
        <translation>Un valor que al volver a leerse es diferente se muestra en rojo y permanece. Deshacer lo último prepara los valores que había antes de la última aplicación.</translation>
    </message>
    <message>
        <source>The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read.</source>
        <translation>Las variables B I D R S P BP y EX con sus nombres, su valor anterior y cuándo cambiaron. Solo se leen las filas visibles.</translation>
    </message>
    <message>
        <source>Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads.</source>
        <translation>No se escribe nada antes de comparar la numeración con la consola de programación: Verificar… lo hace, y solo lee.</translation>
    </message>
    <message>
        <source>Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ.</source>
        <translation>Importar y Exportar utilizan archivos CSV; se pueden pegar celdas de una hoja de cálculo. Tanto al importar como al pegar se muestra primero qué cambiaría.</translation>
    </message>
    <message>
        <source>A watch page is a list of your own: the right mouse button puts rows of any tab on it.</source>
        <translation>Una página de vigilancia es una lista propia: el botón derecho del ratón pone en ella filas de cualquier pestaña.</translation>
    </message>
    <message>
        <source>The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point.</source>
        <translation>El punto de herramienta en el sistema de coordenadas base, con forma y herramienta; los ejes en pulsos, con error de seguimiento, par y temperatura si el modelo los indica; y la trayectoria del punto de herramienta.</translation>
    </message>
    <message>
        <source>Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them.</source>
        <translation>Los grados de los ejes solo aparecen aquí si el perfil indica los pulsos por grado: el controlador no los comunica.</translation>
    </message>
    <message>
        <source>Torque is shown as the controller sends it: its unit is stated nowhere.</source>
        <translation>El par se muestra tal como lo envía el controlador: su unidad no se indica en ninguna parte.</translation>
    </message>
    <message>
        <source>Min and max count from the last reset, while this page is read. Copy as text takes the table in view.</source>
        <translation>El mín. y el máx. cuentan desde el último restablecimiento, mientras se lee esta página. Copiar como texto toma la tabla visible.</translation>
    </message>
    <message>
        <source>Control groups that the controller refuses have no tab; the line beside the tabs counts them.</source>
        <translation>Los grupos de control que el controlador rechaza no tienen pestaña; la línea junto a las pestañas indica cuántos son.</translation>
    </message>
    <message>
        <source>Moves the robot by orders, in automatic operation. The pendant&apos;s enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always.</source>
        <translation>Mueve el robot mediante órdenes, en modo automático. El interruptor de habilitación de la consola de programación no protege aquí a nadie, y nadie debe estar dentro del vallado. En TEACH está siempre desactivado.</translation>
    </message>
    <message>
        <source>Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms.</source>
        <translation>Para armar se necesita el nivel Operación, REMOTE y PLAY; para mover se necesita además el nivel Ingeniería. Perder el foco, un minuto sin teclado ni ratón, una alarma o la pérdida del enlace desarman el controlador.</translation>
    </message>
    <message>
        <source>Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step.</source>
        <translation>Movimiento manual envía un paso limitado tras otro mientras se mantiene pulsado un botón. Al soltarlo no se envían más pasos y el que está en curso se detiene con HOLD; si se pierde el enlace, el robot aun así termina su paso.</translation>
    </message>
    <message>
        <source>Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed.</source>
        <translation>Mover muestra primero la posición actual, el destino y el cambio. Comprobación previa… abre la ventana en la que se confirma el movimiento.</translation>
    </message>
    <message>
        <source>What was sent without an answer is called unknown, never failed: look at the robot.</source>
        <translation>Lo que se envió y quedó sin respuesta se llama desconocido, nunca fallido: observe el robot.</translation>
    </message>
    <message>
        <source>Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal….</source>
        <translation>Dibuja cualquier número a lo largo del tiempo. Arrástrelo aquí desde una página, elija “Añadir a la tendencia” en su menú o utilice Añadir señal….</translation>
    </message>
    <message>
        <source>Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read.</source>
        <translation>Pausa congela la vista; el registro continúa. Los huecos de una curva son periodos en los que no se leyó nada.</translation>
    </message>
    <message>
        <source>The time box chooses how long a time is in view; under the cursor stand the values of that moment.</source>
        <translation>El cuadro de tiempo determina cuánto tiempo abarca la vista; bajo el cursor figuran los valores de ese momento.</translation>
    </message>
    <message>
        <source>An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later.</source>
        <translation>Un incidente conserva 60 s antes y 20 s después de producirse una alarma. Se puede abrir aquí más tarde.</translation>
    </message>
    <message>
        <source>Export CSV… writes what is in view, with times in UTC.</source>
        <translation>Exportar CSV… escribe lo que está en la vista, con las horas en UTC.</translation>
    </message>
    <message>
        <source>The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old.</source>
        <translation>Los trabajos del controlador y el texto del elegido, con la línea que se ejecuta. Un aviso indica cuándo el texto puede ser antiguo.</translation>
    </message>
    <message>
        <source>Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice.</source>
        <translation>Iniciar necesita REMOTE, PLAY, Servo ON, el nivel Operación y un controlador armado. Su ventana indica controlador, trabajo y línea, y el botón funciona al cabo de un segundo. Nunca se inicia nada dos veces.</translation>
    </message>
    <message>
        <source>Buttons show what was read. “Pending” stands until the status agrees.</source>
        <translation>Los botones muestran lo que se leyó. “Pendiente” permanece hasta que el estado coincide.</translation>
    </message>
    <message>
        <source>HOLD from here can be released here. A hold by the pendant is released there.</source>
        <translation>Un HOLD dado desde aquí se puede liberar aquí. Un HOLD por la consola de programación se libera allí.</translation>
    </message>
    <message>
        <source>“Why not?” beside a button lists all its conditions.</source>
        <translation>“¿Por qué no?” junto a un botón enumera todas sus condiciones.</translation>
    </message>
    <message>
        <source>Files of this computer on the left, of the controller on the right, by type.</source>
        <translation>Los archivos de este equipo a la izquierda y los del controlador a la derecha, por tipo.</translation>
    </message>
    <message>
        <source>Fetch only reads. Send and Delete are for engineers and need REMOTE on.</source>
        <translation>Obtener solo lee. Enviar y Borrar necesitan el nivel Ingeniería y REMOTE activado.</translation>
    </message>
    <message>
        <source>A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one.</source>
        <translation>Si un archivo ya existe, se pregunta qué hacer: compararlo, reemplazarlo o dejarlo como está, que es lo predeterminado. Un archivo interrumpido a medias nunca reemplaza a uno correcto.</translation>
    </message>
    <message>
        <source>Before a job is sent its text is checked, and afterwards it is read back and compared.</source>
        <translation>Antes de enviar un trabajo se comprueba su texto, y después se vuelve a leer y se compara.</translation>
    </message>
    <message>
        <source>Transfers lists every file with its bytes and state. Retry failed sends none that was finished.</source>
        <translation>Transferencias enumera cada archivo con sus bytes y su estado. Reintentar fallidas no vuelve a enviar ninguna que haya terminado.</translation>
    </message>
    <message>
        <source>Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole.</source>
        <translation>Las copias de seguridad de este controlador, la más reciente primero, con los archivos que faltan en cada una. ▲ marca la que no está completa.</translation>
    </message>
    <message>
        <source>Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest.</source>
        <translation>Hacer copia ahora lee todos los archivos en una carpeta nueva, con una suma de comprobación de cada uno. Un archivo que falla no detiene los demás.</translation>
    </message>
    <message>
        <source>Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which.</source>
        <translation>Verificar vuelve a leer cada byte. Comparar encuentra lo que difiere de otra copia de seguridad o del controlador ahora; las fechas y los contadores se omiten, y la página indica cuáles.</translation>
    </message>
    <message>
        <source>Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run.</source>
        <translation>Restaurar… primero planifica, hace una copia de seguridad nueva, envía lo modificado y lo vuelve a leer. Se necesita el nivel Ingeniería y REMOTE, y no debe haber ningún trabajo en marcha.</translation>
    </message>
    <message>
        <source>Old backups go by number and age as set below the list, never the last good one or a pinned one.</source>
        <translation>Las copias de seguridad antiguas se borran por número y antigüedad según lo ajustado debajo de la lista; nunca la última correcta ni una fijada.</translation>
    </message>
    <message>
        <source>Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller&apos;s answer.</source>
        <translation>Todo lo que se intentó desde aquí: escrituras, inicios, movimientos, servo, archivos, y lo que se rechazó o no se llegó a enviar, con usuario, valor anterior y nuevo, y la respuesta del controlador.</translation>
    </message>
    <message>
        <source>“Unknown” means that no answer came: it may have happened.</source>
        <translation>“Desconocido” significa que no llegó respuesta: puede haberse ejecutado.</translation>
    </message>
    <message>
        <source>Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down.</source>
        <translation>Filtre por controlador, clase, tiempo y resultado, o busque en todos los textos. Los registros anteriores aparecen al desplazarse hacia abajo.</translation>
    </message>
    <message>
        <source>The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows.</source>
        <translation>El diario se guarda en este equipo para todos los controladores y se puede leer sin conexión. Exportar escribe lo que muestra el filtro.</translation>
    </message>
    <message>
        <source>Go to a signal</source>
        <translation>Ir a una señal</translation>
    </message>
    <message>
        <source>Write the signal (network inputs)</source>
        <translation>Escribir la señal (entradas de red)</translation>
    </message>
    <message>
        <source>On the tab Watch: watch the signal no longer</source>
        <translation>En la pestaña Vigilar: dejar de vigilar la señal</translation>
    </message>
    <message>
        <source>Go to a register</source>
        <translation>Ir a un registro</translation>
    </message>
    <message>
        <source>Open the editor; in it: stage the value</source>
        <translation>Abrir el editor; en él: preparar el valor</translation>
    </message>
    <message>
        <source>Discard the staged value</source>
        <translation>Descartar el valor preparado</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>Copiar las filas seleccionadas</translation>
    </message>
    <message>
        <source>Paste cells: they are staged after a preview</source>
        <translation>Pegar celdas: se preparan tras una vista previa</translation>
    </message>
    <message>
        <source>Go to a variable</source>
        <translation>Ir a una variable</translation>
    </message>
    <message>
        <source>Held on a jog button: steps, if keyboard jog was switched on</source>
        <translation>Manteniéndolas pulsadas en un botón de movimiento manual: pasos, si se activó el movimiento manual con el teclado</translation>
    </message>
    <message>
        <source>In the sheet of the move, after typing its words: move</source>
        <translation>En la ventana del movimiento, tras escribir el texto que pide: mover</translation>
    </message>
    <message>
        <source>In the plot: move the cursor</source>
        <translation>En la curva: mover el cursor</translation>
    </message>
    <message>
        <source>In the plot: cursor to the oldest or newest time in view</source>
        <translation>En la curva: cursor al momento más antiguo o más reciente de la vista</translation>
    </message>
    <message>
        <source>In the plot: take the cursor away</source>
        <translation>En la curva: quitar el cursor</translation>
    </message>
    <message>
        <source>In the list of signals: remove it from the trend</source>
        <translation>En la lista de señales: quitarla de la tendencia</translation>
    </message>
    <message>
        <source>In the start sheet, after typing its words: start</source>
        <translation>En la ventana de inicio, tras escribir el texto que pide: iniciar</translation>
    </message>
    <message>
        <source>Copy the chosen rows of the list with the focus</source>
        <translation>Copiar las filas seleccionadas de la lista que tiene el foco</translation>
    </message>
    <message>
        <source>“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which.</source>
        <translation>“Trabajo” es lo que nombra el controlador: en reposo, el trabajo que empezaría con un inicio; si no, el que está en marcha. “Marcha” indica cuál.</translation>
    </message>
    <message>
        <source>All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order.</source>
        <translation>Todos los controladores uno junto al otro: primero los que están en alarma, después los que no tienen enlace y los que están en HOLD, y luego los demás en un orden fijo.</translation>
    </message>
    <message>
        <source>A click opens a controller’s pages. The others stay connected and are read once a second.</source>
        <translation>Un clic abre las páginas de un controlador. Los demás siguen conectados y se leen una vez por segundo.</translation>
    </message>
    <message>
        <source>HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop.</source>
        <translation>HOLD A TODOS ordena una retención por software en cada controlador que no esté desconectado, no pregunta nada e indica de cada uno si se confirmó. No es una parada de emergencia.</translation>
    </message>
    <message>
        <source>Connect all and Back up all only read. Nothing else goes to several controllers at once.</source>
        <translation>Conectar todos y Copia de todos solo leen. Nada más se envía a varios controladores a la vez.</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Flota</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valores separados por comas (*.csv)</translation>
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
        <translation>Se solicitaron un grupo de señales y una variable B: %1.</translation>
    </message>
    <message>
        <source>A signal group and a B variable are asked for while this sheet is open. Writing needs no REMOTE; whether data are protected cannot be read.</source>
        <translation>Se solicitan un grupo de señales y una variable B mientras esta ventana está abierta. Para escribir no se necesita REMOTE; no se puede leer si los datos están protegidos.</translation>
    </message>
    <message>
        <source>The software version, which tells the model, was not read yet.</source>
        <translation>La versión del software, que indica el modelo, aún no se ha leído.</translation>
    </message>
    <message>
        <source>The profile says %1, but %2 is the software of a %3.</source>
        <translation>El perfil indica %1, pero %2 es el software de un %3.</translation>
    </message>
    <message>
        <source>The software %1 does not tell the model. The ranges are those of the profile&apos;s %2.</source>
        <translation>El software %1 no indica el modelo. Los rangos son los de %2, el modelo del perfil.</translation>
    </message>
    <message>
        <source>The software %1 is that of a %2. Its ranges come from a table, not from the controller.</source>
        <translation>El software %1 es el de un %2. Sus rangos proceden de una tabla, no del controlador.</translation>
    </message>
    <message>
        <source>The last HOLD was refused: %1.</source>
        <translation>El último HOLD fue rechazado: %1.</translation>
    </message>
    <message>
        <source>The last HOLD was confirmed by the status. It is a software hold, no emergency stop.</source>
        <translation>El último HOLD fue confirmado por el estado. Es una retención por software, no una parada de emergencia.</translation>
    </message>
    <message>
        <source>The last HOLD was sent, and the status did not confirm it.</source>
        <translation>El último HOLD se envió y el estado no lo confirmó.</translation>
    </message>
    <message>
        <source>It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.</source>
        <translation>No necesita REMOTE ni nivel de acceso, y no se ha probado. Es una retención por software, no una parada de emergencia.</translation>
    </message>
    <message>
        <source>A list of jobs was asked for at port %1: %2.</source>
        <translation>Se solicitó una lista de trabajos en el puerto %1: %2.</translation>
    </message>
    <message>
        <source>A list of jobs is asked for at port %1.</source>
        <translation>Se solicita una lista de trabajos en el puerto %1.</translation>
    </message>
    <message>
        <source>Port %1 lists the jobs. Sending and deleting files need REMOTE.</source>
        <translation>El puerto %1 muestra la lista de trabajos. Para enviar y borrar archivos se necesita REMOTE.</translation>
    </message>
    <message>
        <source>This simulation has B000 at number %1 on the network.</source>
        <translation>En esta simulación, B000 es el número %1 en la red.</translation>
    </message>
    <message>
        <source>The software version, with which it was compared, was not read yet.</source>
        <translation>La versión del software con la que se comparó aún no se ha leído.</translation>
    </message>
    <message>
        <source>It was compared with software %1, but %2 runs now: variables are not written before it is compared again.</source>
        <translation>Se comparó con el software %1, pero ahora se ejecuta %2: no se escriben variables antes de volver a compararla.</translation>
    </message>
    <message>
        <source>Whether B000 is number 0 or 1 on the network is unverified; variables are not written.</source>
        <translation>No se ha verificado si B000 es el número 0 o 1 en la red; no se escriben variables.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1: number 0 on the network is B000.</source>
        <translation>Comparada con la consola de programación el %1: el número 0 en la red es B000.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1, shifted: number 1 on the network is B000.</source>
        <translation>Comparada con la consola de programación el %1, desplazada: el número 1 en la red es B000.</translation>
    </message>
    <message>
        <source>The controller does not answer any more. Reading resumes by itself.</source>
        <translation>El controlador ya no responde. La lectura se reanuda por sí sola.</translation>
    </message>
    <message>
        <source>The controller tells its status and system information. Reading needs no REMOTE.</source>
        <translation>El controlador comunica su estado y su información del sistema. Para leer no se necesita REMOTE.</translation>
    </message>
    <message>
        <source>Orders are taken in command remote alone: start, select, reset, cycle, servo on.</source>
        <translation>Solo se aceptan órdenes en remoto por comando (command remote): iniciar, seleccionar, restablecer, ciclo, Servo ON.</translation>
    </message>
    <message>
        <source>It needs REMOTE, and that no job runs.</source>
        <translation>Se necesita REMOTE y que no haya ningún trabajo en marcha.</translation>
    </message>
    <message>
        <source>It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.</source>
        <translation>Se necesita PLAY, REMOTE, Servo ON y un trabajo, y que nada retenga el robot.</translation>
    </message>
    <message>
        <source>It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken without REMOTE is up to the controller.</source>
        <translation>Se necesita PLAY y REMOTE. Servo OFF siempre se puede ordenar desde aquí; que se acepte sin REMOTE depende del controlador.</translation>
    </message>
    <message>
        <source>They need what a start needs, but for the job, and a model that knows them.</source>
        <translation>Necesitan lo mismo que un inicio, excepto el trabajo, y un modelo que los admita.</translation>
    </message>
    <message>
        <source>Sending a file that exists there needs REMOTE and two parameters.</source>
        <translation>Para enviar un archivo que ya existe allí se necesitan REMOTE y dos parámetros.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lectura</translation>
    </message>
    <message>
        <source>I/O and variables</source>
        <translation>E/S y variables</translation>
    </message>
    <message>
        <source>Ranges of the model</source>
        <translation>Rangos del modelo</translation>
    </message>
    <message>
        <source>Orders (REMOTE)</source>
        <translation>Órdenes (REMOTE)</translation>
    </message>
    <message>
        <source>Selecting a job</source>
        <translation>Seleccionar un trabajo</translation>
    </message>
    <message>
        <source>Starting a job</source>
        <translation>Iniciar un trabajo</translation>
    </message>
    <message>
        <source>Switching servo on</source>
        <translation>Conectar los servos (Servo ON)</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>Movimiento manual y desplazamiento</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (software)</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Replacing files</source>
        <translation>Reemplazar archivos</translation>
    </message>
    <message>
        <source>Numbering of variables</source>
        <translation>Numeración de variables</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>permitido</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>no permitido</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medido</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supuesto</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>no se puede leer</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>aún no leído</translation>
    </message>
    <message>
        <source>In the way: %1.</source>
        <translation>Lo impide: %1.</translation>
    </message>
    <message>
        <source>HSES does not tell whether this is so: %1.</source>
        <translation>HSES no indica si esto se cumple: %1.</translation>
    </message>
    <message>
        <source>What helps: %1.</source>
        <translation>Qué hacer: %1.</translation>
    </message>
    <message>
        <source>Diagnose… in the rail finds out at which step it fails.</source>
        <translation>Diagnóstico… en la barra de navegación averigua en qué paso falla.</translation>
    </message>
    <message>
        <source>Correct the model in the profile (Connect…).</source>
        <translation>Corrija el modelo en el perfil (Conectar…).</translation>
    </message>
    <message>
        <source>Use the pendant.</source>
        <translation>Utilice la consola de programación.</translation>
    </message>
    <message>
        <source>Pendesk %1, readiness of %2 (%3), %4, %5</source>
        <translation>Pendesk %1, disponibilidad de %2 (%3), %4, %5</translation>
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
        <translation>La línea no contiene los números que debería.</translation>
    </message>
</context>
<context>
    <name>Shown</name>
    <message>
        <source>Not read yet.</source>
        <translation>Aún no leído.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Rechazado: %1</translation>
    </message>
    <message>
        <source>Last seen %1</source>
        <translation>Visto por última vez: %1</translation>
    </message>
    <message>
        <source>not taught</source>
        <translation>no enseñado</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>HELD</source>
        <translation>EN HOLD</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>PENDANT</source>
        <translation>CONSOLA</translation>
    </message>
    <message>
        <source>EXTERNAL</source>
        <translation>EXTERNO</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMANDO</translation>
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
        <translation>SIN MODO</translation>
    </message>
    <message>
        <source>REMOTE %1</source>
        <translation>REMOTE %1</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>PASO</translation>
    </message>
    <message>
        <source>1 CYCLE</source>
        <translation>1 CICLO</translation>
    </message>
    <message>
        <source>CONTINUOUS</source>
        <translation>CONTINUO</translation>
    </message>
    <message>
        <source>NO CYCLE</source>
        <translation>SIN CICLO</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>EN MARCHA</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>parado</translation>
    </message>
    <message>
        <source>ON</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>ALARMA</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>ERROR</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarma</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
    </message>
    <message>
        <source>held</source>
        <translation>en HOLD</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>contradictorio</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en marcha</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>inactivo</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>line %1 · step %2 · %3</source>
        <translation>línea %1 · paso %2 · %3</translation>
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
        <translation>pulsos</translation>
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
        <translation>HOLD solicitado, %1 s…</translation>
    </message>
    <message>
        <source>held by command</source>
        <translation>en HOLD por comando</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>en HOLD por la consola</translation>
    </message>
    <message>
        <source>held externally</source>
        <translation>en HOLD externo</translation>
    </message>
    <message>
        <source>HOLD refused</source>
        <translation>HOLD rechazado</translation>
    </message>
    <message>
        <source>HOLD not confirmed</source>
        <translation>HOLD no confirmado</translation>
    </message>
    <message>
        <source>released</source>
        <translation>liberado</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>HOLD por software · tecla Pausa</translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message>
        <source>%1 changed</source>
        <translation>%1: cambiado</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nuevo</translation>
    </message>
    <message>
        <source>%1: gone.</source>
        <translation>%1: eliminado.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>%n línea difiere, a partir de la línea %1.</numerusform>
            <numerusform>%n líneas difieren, a partir de la línea %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The newer file is empty; what stood in it is not known to be deleted.</source>
        <translation>El archivo más reciente está vacío; no se sabe si lo que contenía se ha borrado.</translation>
    </message>
    <message>
        <source>The older file is empty.</source>
        <translation>El archivo anterior está vacío.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>Y %n diferencia más.</numerusform>
            <numerusform>Y %n diferencias más.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes; the content differs.</source>
        <translation>%1 bytes; el contenido difiere.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>moved %1 mm (%2)</source>
        <translation>movido %1 mm (%2)</translation>
    </message>
    <message>
        <source>turned %1 deg (%2)</source>
        <translation>girado %1 grados (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>Lo utiliza %n trabajo.</numerusform>
            <numerusform>Lo utilizan %n trabajos.</numerusform>
        </translation>
    </message>
    <message>
        <source>could not be read in one of the files</source>
        <translation>no se pudo leer en uno de los archivos</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>nombre %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>punto %1</translation>
    </message>
    <message>
        <source>weight %1 kg</source>
        <translation>peso %1 kg</translation>
    </message>
    <message>
        <source>centre of gravity %1 mm</source>
        <translation>centro de gravedad %1 mm</translation>
    </message>
    <message>
        <source>inertia %1 kgm²</source>
        <translation>inercia %1 kgm²</translation>
    </message>
    <message>
        <source>kind of entry %1</source>
        <translation>tipo de entrada %1</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>%1 es nuevo.</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1 ya no existe.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Herramienta %1</translation>
    </message>
    <message>
        <source>User frame %1</source>
        <translation>Sistema de usuario %1</translation>
    </message>
    <message>
        <source>where it lies could not be read in one of the files</source>
        <translation>su ubicación no se pudo leer en uno de los archivos</translation>
    </message>
    <message>
        <source>taught with tool %1</source>
        <translation>enseñado con herram. %1</translation>
    </message>
    <message>
        <source>taught at other points</source>
        <translation>enseñado en otros puntos</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>Área %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>definida</translation>
    </message>
    <message>
        <source>no longer set</source>
        <translation>ya no definida</translation>
    </message>
    <message>
        <source>upper %1 %2 mm</source>
        <translation>superior %1 %2 mm</translation>
    </message>
    <message>
        <source>lower %1 %2 mm</source>
        <translation>inferior %1 %2 mm</translation>
    </message>
    <message>
        <source>other coordinates or another group</source>
        <translation>otras coordenadas u otro grupo</translation>
    </message>
    <message>
        <source>Collision detection, set %1, group %2</source>
        <translation>Detección de colisiones, conjunto %1, grupo %2</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>desactivada</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>activada</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>nivel %1</translation>
    </message>
    <message>
        <source>robot %1 limit %2 %3 %4 deg</source>
        <translation>robot %1 límite %2 %3 %4 grados</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>cambiado</translation>
    </message>
    <message>
        <source>meaning not known</source>
        <translation>significado desconocido</translation>
    </message>
    <message>
        <source>Section %1 has %2 values.</source>
        <translation>La sección %1 tiene %2 valores.</translation>
    </message>
    <message>
        <source>System part</source>
        <translation>Parte del sistema</translation>
    </message>
    <message>
        <source>User part</source>
        <translation>Parte del usuario</translation>
    </message>
    <message>
        <source>decides %1</source>
        <translation>determina %1</translation>
    </message>
    <message>
        <source>%1, instruction %2: %3</source>
        <translation>%1, instrucción %2: %3</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>%1 pasó a ser %2</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1 es nuevo</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 ya no existe</translation>
    </message>
    <message>
        <source>Now also written: %1.</source>
        <translation>Ahora también se escribe: %1.</translation>
    </message>
    <message>
        <source>No longer written: %1.</source>
        <translation>Ya no se escribe: %1.</translation>
    </message>
    <message>
        <source>The control group %1 is another one.</source>
        <translation>El grupo de control %1 es otro.</translation>
    </message>
    <message>
        <source>Another number of control groups.</source>
        <translation>Otro número de grupos de control.</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>The hours of control power went back by %1: another controller, or its memory was cleared.</source>
        <translation>Las horas de alimentación de control retrocedieron %1: es otro controlador o se borró su memoria.</translation>
    </message>
    <message>
        <source>%1 powered in between.</source>
        <translation>%1 de alimentación entretanto.</translation>
    </message>
    <message>
        <source>Section %1 is new.</source>
        <translation>La sección %1 es nueva.</translation>
    </message>
    <message>
        <source>Section %1 is not in the newer file.</source>
        <translation>La sección %1 no está en el archivo más reciente.</translation>
    </message>
    <message>
        <source>Presets of timers and counters changed.</source>
        <translation>Cambiaron los ajustes de temporizadores y contadores.</translation>
    </message>
    <message>
        <source>Home position of %1 axis %2 recalibrated (%3): taught points may be off.</source>
        <translation>Posición de origen de %1, eje %2, recalibrada (%3): los puntos enseñados pueden estar desviados.</translation>
    </message>
    <message>
        <source>Position of %1 axis %2: %3 pulses.</source>
        <translation>Posición de %1, eje %2: %3 pulsos.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ON</translation>
    </message>
    <message>
        <source>off</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source> Command remote select: HSES control is permitted.</source>
        <translation> Remoto por comando (command remote): se permite el control por HSES.</translation>
    </message>
    <message>
        <source> Command remote select: HSES control will be refused.</source>
        <translation> Remoto por comando (command remote): el control por HSES será rechazado.</translation>
    </message>
    <message>
        <source>Pseudo input %1 switched %2.</source>
        <translation>La pseudoentrada %1 pasó a %2.</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Parameter version</source>
        <translation>Versión de parámetros</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>Aplicaciones</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Placas</translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>%n entrada nueva.</numerusform>
            <numerusform>%n entradas nuevas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The log rolled over: edits in between are not known.</source>
        <translation>El registro dio la vuelta: se desconocen las ediciones intermedias.</translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>%n alarma nueva: %1.</numerusform>
            <numerusform>%n alarmas nuevas: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>coordinates %1</source>
        <translation>coordenadas %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>herramienta %1</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>sistema de usuario %1</translation>
    </message>
    <message>
        <source>form of the arm</source>
        <translation>forma del brazo</translation>
    </message>
    <message>
        <source>now set (%1)</source>
        <translation>ahora definida (%1)</translation>
    </message>
    <message>
        <source>Number of variables %1</source>
        <translation>Número de variables %1</translation>
    </message>
    <message>
        <source>%1 lost its name “%2”.</source>
        <translation>%1 perdió su nombre “%2”.</translation>
    </message>
    <message>
        <source>%1 is now named “%2”.</source>
        <translation>%1 se llama ahora “%2”.</translation>
    </message>
    <message>
        <source>%1 “%2” is now named “%3”.</source>
        <translation>%1 “%2” se llama ahora “%3”.</translation>
    </message>
    <message>
        <source>written</source>
        <translation>escrito</translation>
    </message>
    <message>
        <source>read</source>
        <translation>leído</translation>
    </message>
    <message>
        <source>waited for</source>
        <translation>esperado</translation>
    </message>
    <message>
        <source>called</source>
        <translation>llamado</translation>
    </message>
    <message>
        <source>jumped to</source>
        <translation>destino de salto</translation>
    </message>
    <message>
        <source>started</source>
        <translation>iniciado</translation>
    </message>
    <message>
        <source>named</source>
        <translation>nombrado</translation>
    </message>
    <message>
        <source>may be %1</source>
        <translation>quizá %1</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 línea %2</translation>
    </message>
    <message>
        <source>%1 is called, and no file has it: %2.</source>
        <translation>Se llama a %1 y ningún archivo lo contiene: %2.</translation>
    </message>
    <message>
        <source>%1 is written in several places: %2.</source>
        <translation>%1 se escribe en varios lugares: %2.</translation>
    </message>
    <message>
        <source>%1 is read and never written in the files: %2.</source>
        <translation>%1 se lee y nunca se escribe en los archivos: %2.</translation>
    </message>
    <message>
        <source>%1 has several names: %2.</source>
        <translation>%1 tiene varios nombres: %2.</translation>
    </message>
    <message>
        <source>%1 is used and its data were not entered: %2.</source>
        <translation>%1 se usa y sus datos no se han introducido: %2.</translation>
    </message>
    <message>
        <source>%1 is named by no other job and no macro.</source>
        <translation>Ningún otro job ni macro nombra a %1.</translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message>
        <source>values</source>
        <translation>valores</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloque</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>entrada</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>job</source>
        <translation>trabajo</translation>
    </message>
    <message>
        <source>line</source>
        <translation>línea</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texto</translation>
    </message>
    <message>
        <source>collision detection</source>
        <translation>detección de colisiones</translation>
    </message>
    <message>
        <source>set</source>
        <translation>conjunto</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupo</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activado</translation>
    </message>
    <message>
        <source>level</source>
        <translation>nivel</translation>
    </message>
    <message>
        <source>reasons of stops</source>
        <translation>motivos de paradas</translation>
    </message>
    <message>
        <source>number</source>
        <translation>número</translation>
    </message>
    <message>
        <source>date</source>
        <translation>fecha</translation>
    </message>
    <message>
        <source>reasons</source>
        <translation>motivos</translation>
    </message>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>La línea no contiene los números que debería.</translation>
    </message>
    <message>
        <source>The block has no number.</source>
        <translation>El bloque no tiene número.</translation>
    </message>
    <message>
        <source>Tool %1 is not complete.</source>
        <translation>Herramienta %1 incompleta.</translation>
    </message>
    <message>
        <source>User frame %1 is not complete: where it lies is unknown.</source>
        <translation>El sistema de usuario %1 no está completo: se desconoce su ubicación.</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>Sistemas de usuario</translation>
    </message>
    <message>
        <source>Interference areas</source>
        <translation>Áreas de interferencia</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>Detección de colisiones</translation>
    </message>
    <message>
        <source>Weaving conditions</source>
        <translation>Condiciones de oscilación</translation>
    </message>
    <message>
        <source>Arc start conditions</source>
        <translation>Condiciones inicio de arco</translation>
    </message>
    <message>
        <source>Arc end conditions</source>
        <translation>Condiciones fin de arco</translation>
    </message>
    <message>
        <source>Arc auxiliary conditions</source>
        <translation>Condiciones auxiliares de arco</translation>
    </message>
    <message>
        <source>Welders</source>
        <translation>Equipos de soldadura</translation>
    </message>
    <message>
        <source>Cutting shapes</source>
        <translation>Formas de corte</translation>
    </message>
    <message>
        <source>Maintenance conditions</source>
        <translation>Condiciones de mantenimiento</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Names of variables</source>
        <translation>Nombres de variables</translation>
    </message>
    <message>
        <source>Names of signals</source>
        <translation>Nombres de señales</translation>
    </message>
    <message>
        <source>Names of external signals</source>
        <translation>Nombres de señales externas</translation>
    </message>
    <message>
        <source>Names of registers</source>
        <translation>Nombres de registros</translation>
    </message>
    <message>
        <source>Names of timers</source>
        <translation>Nombres de temporizadores</translation>
    </message>
    <message>
        <source>Timers</source>
        <translation>Temporizadores</translation>
    </message>
    <message>
        <source>Timer settings</source>
        <translation>Ajustes de temporizadores</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Lista de vigilancia</translation>
    </message>
    <message>
        <source>Groups of signals</source>
        <translation>Grupos de señales</translation>
    </message>
    <message>
        <source>User words</source>
        <translation>Palabras de usuario</translation>
    </message>
    <message>
        <source>User menus</source>
        <translation>Menús de usuario</translation>
    </message>
    <message>
        <source>Names of flags</source>
        <translation>Nombres de indicadores</translation>
    </message>
    <message>
        <source>Key functions</source>
        <translation>Funciones de teclas</translation>
    </message>
    <message>
        <source>Interface panels</source>
        <translation>Paneles de interfaz</translation>
    </message>
    <message>
        <source>Macro commands</source>
        <translation>Comandos de macro</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>Ladder</translation>
    </message>
    <message>
        <source>Pseudo inputs</source>
        <translation>Pseudoentradas</translation>
    </message>
    <message>
        <source>I/O boards</source>
        <translation>Placas de E/S</translation>
    </message>
    <message>
        <source>I/O axes</source>
        <translation>Ejes de E/S</translation>
    </message>
    <message>
        <source>EtherNet/IP</source>
        <translation>EtherNet/IP</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Red</translation>
    </message>
    <message>
        <source>Address translation</source>
        <translation>Traducción de direcciones</translation>
    </message>
    <message>
        <source>Remote users</source>
        <translation>Usuarios remotos</translation>
    </message>
    <message>
        <source>Home positions of the encoders</source>
        <translation>Posiciones de origen de los encoders</translation>
    </message>
    <message>
        <source>Second home position</source>
        <translation>Segunda posición de origen</translation>
    </message>
    <message>
        <source>Operation origin</source>
        <translation>Origen de operación</translation>
    </message>
    <message>
        <source>Robot calibration</source>
        <translation>Calibración de robots</translation>
    </message>
    <message>
        <source>Tool interference</source>
        <translation>Interferencia herramienta</translation>
    </message>
    <message>
        <source>Arrangement of robots</source>
        <translation>Disposición de los robots</translation>
    </message>
    <message>
        <source>Approach buzzer</source>
        <translation>Avisador de aproximación</translation>
    </message>
    <message>
        <source>Servo assistance</source>
        <translation>Asistencia de servo</translation>
    </message>
    <message>
        <source>Safety logic</source>
        <translation>Lógica de seguridad</translation>
    </message>
    <message>
        <source>Range limits</source>
        <translation>Límites de rango</translation>
    </message>
    <message>
        <source>Axis speed monitor</source>
        <translation>Monitor velocidad de ejes</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>Límites de velocidad</translation>
    </message>
    <message>
        <source>Tool angle monitor</source>
        <translation>Monitor ángulo herramienta</translation>
    </message>
    <message>
        <source>Check sums of safety data</source>
        <translation>Sumas de control de seguridad</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>System, options and change dates</source>
        <translation>Sistema, opciones y fechas de cambio</translation>
    </message>
    <message>
        <source>Operation log</source>
        <translation>Registro de operaciones</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Historial de alarmas</translation>
    </message>
    <message>
        <source>Message history</source>
        <translation>Historial de mensajes</translation>
    </message>
    <message>
        <source>Fast events</source>
        <translation>Eventos rápidos</translation>
    </message>
    <message>
        <source>Reasons of stops</source>
        <translation>Motivos de paradas</translation>
    </message>
    <message>
        <source>Maintenance counters</source>
        <translation>Contadores de mantenimiento</translation>
    </message>
    <message>
        <source>Torque counters</source>
        <translation>Contadores de par</translation>
    </message>
    <message>
        <source>Encoder heat</source>
        <translation>Temperatura de encoders</translation>
    </message>
    <message>
        <source>Step diagnosis</source>
        <translation>Diagnóstico de pasos</translation>
    </message>
    <message>
        <source>Job monitor</source>
        <translation>Monitor de trabajos</translation>
    </message>
    <message>
        <source>Robot monitor</source>
        <translation>Monitor de robots</translation>
    </message>
    <message>
        <source>Servo monitor</source>
        <translation>Monitor de servos</translation>
    </message>
    <message>
        <source>Regeneration unit</source>
        <translation>Unidad de regeneración</translation>
    </message>
    <message>
        <source>Memory image</source>
        <translation>Imagen de memoria</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Unknown file</source>
        <translation>Archivo desconocido</translation>
    </message>
    <message>
        <source>The file ends before the values of %1.</source>
        <translation>El archivo termina antes de los valores de %1.</translation>
    </message>
    <message>
        <source>The control groups of this line could not be read.</source>
        <translation>No se pudieron leer los grupos de control de esta línea.</translation>
    </message>
    <message>
        <source>This section is not understood.</source>
        <translation>Esta sección no se comprende.</translation>
    </message>
    <message>
        <source>“%1” is not understood.</source>
        <translation>“%1” no se comprende.</translation>
    </message>
    <message>
        <source>The record in front of this date is not understood.</source>
        <translation>El registro que precede a esta fecha no se comprende.</translation>
    </message>
    <message>
        <source>The record that begins here is not complete.</source>
        <translation>El registro que empieza aquí no está completo.</translation>
    </message>
    <message>
        <source>The section %1 announces %2 records and holds %3.</source>
        <translation>La sección %1 anuncia %2 registros y contiene %3.</translation>
    </message>
    <message>
        <source>The entry is numbered %1 and is number %2 by its place.</source>
        <translation>La entrada lleva el número %1 y por su lugar es la número %2.</translation>
    </message>
    <message>
        <source>The entry is not complete.</source>
        <translation>La entrada no está completa.</translation>
    </message>
    <message>
        <source>The number of the macro cannot be read.</source>
        <translation>No se puede leer el número de la macro.</translation>
    </message>
    <message>
        <source>The line holds NUL bytes.</source>
        <translation>La línea contiene bytes NUL.</translation>
    </message>
    <message>
        <source>Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF before it is loaded.</source>
        <translation>Las líneas terminan solo en LF. Una consola de programación puede tomar por vacío un archivo así: conviértalo a CR LF antes de cargarlo.</translation>
    </message>
    <message>
        <source>The file ends within a line: it may be cut.</source>
        <translation>El archivo termina dentro de una línea: puede estar cortado.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>El archivo está vacío.</translation>
    </message>
    <message>
        <source>The file is too long to be read.</source>
        <translation>El archivo es demasiado largo para leerlo.</translation>
    </message>
    <message>
        <source>%1 has no section “%2”; the rows below it are not understood.</source>
        <translation>%1 no tiene la sección “%2”; las filas que siguen no se comprenden.</translation>
    </message>
    <message>
        <source>The row has %1 instead of 10 values; the missing ones of %2 are unknown.</source>
        <translation>La fila tiene %1 valores en lugar de 10; se desconocen los que faltan de %2.</translation>
    </message>
    <message>
        <source>%1 is no number of 32 bits.</source>
        <translation>%1 no es un número de 32 bits.</translation>
    </message>
    <message>
        <source>data transmission; 2 is over the network</source>
        <translation>transmisión de datos; 2 es por la red</translation>
    </message>
    <message>
        <source>numbering of variables for network clients; 1: by their number, 0: by their number plus one</source>
        <translation>numeración de variables para clientes de red; 1: por su número, 0: por su número más uno</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files</source>
        <translation>1 permite a los clientes de red sobrescribir archivos</translation>
    </message>
    <message>
        <source>serial transmission: data bits, parity, stop, speed, timers</source>
        <translation>transmisión serie: bits de datos, paridad, parada, velocidad, temporizadores</translation>
    </message>
    <message>
        <source>3 permits overwriting when loading from USB</source>
        <translation>3 permite sobrescribir al cargar desde USB</translation>
    </message>
    <message>
        <source>address and mask of the controller</source>
        <translation>dirección y máscara del controlador</translation>
    </message>
    <message>
        <source>1 permits FTP</source>
        <translation>1 permite FTP</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files; the meaning of 2 is not known</source>
        <translation>1 permite a los clientes de red sobrescribir archivos; se desconoce el significado de 2</translation>
    </message>
    <message>
        <source>addresses and masks</source>
        <translation>direcciones y máscaras</translation>
    </message>
    <message>
        <source>0 permits selecting jobs in remote and play</source>
        <translation>0 permite seleccionar trabajos en REMOTE y PLAY</translation>
    </message>
    <message>
        <source>pendant operation in remote; 63 permits starts and edits</source>
        <translation>operación con la consola en REMOTE; 63 permite inicios y ediciones</translation>
    </message>
    <message>
        <source>alias function; 0 permits loading own names</source>
        <translation>función de alias; 0 permite cargar nombres propios</translation>
    </message>
    <message>
        <source>drivers that start motion need 0</source>
        <translation>los drivers que mueven el robot necesitan 0</translation>
    </message>
    <message>
        <source>MotoPlus and telnet settings</source>
        <translation>ajustes de MotoPlus y telnet</translation>
    </message>
    <message>
        <source>number of variables of each kind</source>
        <translation>número de variables de cada tipo</translation>
    </message>
    <message>
        <source>control groups and their axes</source>
        <translation>grupos de control y sus ejes</translation>
    </message>
    <message>
        <source>pseudo input signals</source>
        <translation>señales de pseudoentrada</translation>
    </message>
    <message>
        <source>The name “%1” holds bytes that the text encoding does not know.</source>
        <translation>El nombre “%1” contiene bytes que la codificación de texto no conoce.</translation>
    </message>
    <message>
        <source>The row has more than four names.</source>
        <translation>La fila tiene más de cuatro nombres.</translation>
    </message>
    <message>
        <source>There are more names than signals.</source>
        <translation>Hay más nombres que señales.</translation>
    </message>
    <message>
        <source>The row is not a number, two flags and a name.</source>
        <translation>La fila no consta de un número, dos indicadores y un nombre.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1 está más allá de la %n variable que el archivo anuncia.</numerusform>
            <numerusform>%1 está más allá de las %n variables que el archivo anuncia.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was named “%2” before; which name the pendant shows is not known.</source>
        <translation>%1 ya tenía antes el nombre “%2”; no se sabe qué nombre muestra la consola de programación.</translation>
    </message>
    <message>
        <source>The line stands in a section that names no signals.</source>
        <translation>La línea está en una sección que no da nombre a señales.</translation>
    </message>
    <message>
        <source>The line does not announce a number for each of the eight kinds.</source>
        <translation>La línea no anuncia un número para cada uno de los ocho tipos.</translation>
    </message>
    <message>
        <source>The hours could not be read.</source>
        <translation>No se pudieron leer las horas.</translation>
    </message>
    <message>
        <source>The file does not say the version of the system software.</source>
        <translation>El archivo no indica la versión del software del sistema.</translation>
    </message>
    <message>
        <source>system</source>
        <translation>sistema</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modelo</translation>
    </message>
    <message>
        <source>software</source>
        <translation>software</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>parámetros</translation>
    </message>
    <message>
        <source>application</source>
        <translation>aplicación</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1, %n eje</numerusform>
            <numerusform>%1, %n ejes</numerusform>
        </translation>
    </message>
    <message>
        <source>boards</source>
        <translation>placas</translation>
    </message>
    <message>
        <source>board</source>
        <translation>placa</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>horas</translation>
    </message>
    <message>
        <source>counter</source>
        <translation>contador</translation>
    </message>
    <message>
        <source>options</source>
        <translation>opciones</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>ajustes</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>parámetro</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>significado</translation>
    </message>
    <message>
        <source>ladder</source>
        <translation>ladder</translation>
    </message>
    <message>
        <source>part</source>
        <translation>parte</translation>
    </message>
    <message>
        <source>instruction</source>
        <translation>instrucción</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>textos</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabla</translation>
    </message>
    <message>
        <source>operation log</source>
        <translation>registro de operaciones</translation>
    </message>
    <message>
        <source>event</source>
        <translation>evento</translation>
    </message>
    <message>
        <source>alarm history</source>
        <translation>historial de alarmas</translation>
    </message>
    <message>
        <source>class</source>
        <translation>clase</translation>
    </message>
    <message>
        <source>code</source>
        <translation>código</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>detalle</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>modo</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>no introducido</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
    <message>
        <source>measured load</source>
        <translation>carga medida</translation>
    </message>
    <message>
        <source>base coordinates</source>
        <translation>coord. base</translation>
    </message>
    <message>
        <source>robot coordinates</source>
        <translation>coord. de robot</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>sistema de usuario %1</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>sin usar</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>herramientas</translation>
    </message>
    <message>
        <source>weight kg</source>
        <translation>peso kg</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>introducido</translation>
    </message>
    <message>
        <source>user frames</source>
        <translation>sistemas de usuario</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>herramienta</translation>
    </message>
    <message>
        <source>interference areas</source>
        <translation>áreas de interferencia</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>coordenadas</translation>
    </message>
    <message>
        <source>lower X mm</source>
        <translation>X inferior mm</translation>
    </message>
    <message>
        <source>upper X mm</source>
        <translation>X superior mm</translation>
    </message>
    <message>
        <source>lower Y mm</source>
        <translation>Y inferior mm</translation>
    </message>
    <message>
        <source>upper Y mm</source>
        <translation>Y superior mm</translation>
    </message>
    <message>
        <source>lower Z mm</source>
        <translation>Z inferior mm</translation>
    </message>
    <message>
        <source>upper Z mm</source>
        <translation>Z superior mm</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>no definido</translation>
    </message>
    <message>
        <source>variables</source>
        <translation>variables</translation>
    </message>
    <message>
        <source>variable</source>
        <translation>variable</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>posiciones</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>sistema de usuario</translation>
    </message>
    <message>
        <source>form</source>
        <translation>forma</translation>
    </message>
    <message>
        <source>names</source>
        <translation>nombres</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>señal</translation>
    </message>
    <message>
        <source>register</source>
        <translation>registro</translation>
    </message>
    <message>
        <source>timer</source>
        <translation>temporizador</translation>
    </message>
    <message>
        <source>home positions, pulses</source>
        <translation>posiciones de origen, pulsos</translation>
    </message>
    <message>
        <source>pseudo inputs</source>
        <translation>pseudoentradas</translation>
    </message>
    <message>
        <source>byte</source>
        <translation>byte</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>bits</translation>
    </message>
    <message>
        <source>The value of %1 could not be read.</source>
        <translation>No se pudo leer el valor de %1.</translation>
    </message>
    <message>
        <source>The file announces %1 variables %2 and has %3; the others are not known.</source>
        <translation>El archivo anuncia %1 variables %2 y tiene %3; las demás se desconocen.</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>pulso</translation>
    </message>
    <message>
        <source>tool coordinates</source>
        <translation>coord. de herramienta</translation>
    </message>
    <message>
        <source>user coordinates</source>
        <translation>coord. de usuario</translation>
    </message>
    <message>
        <source>master tool coordinates</source>
        <translation>coord. de herramienta maestra</translation>
    </message>
</context>
<context>
    <name>dialogs::AccessSettingsDialog</name>
    <message>
        <source>Passcode and idle time</source>
        <translation>Contraseña y tiempo de inactividad</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Back to Monitor after</source>
        <translation>Volver a Supervisión tras</translation>
    </message>
    <message>
        <source>New passcode</source>
        <translation>Contraseña nueva</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>Repetir la contraseña</translation>
    </message>
    <message>
        <source>Leave both empty for no passcode.</source>
        <translation>Deje ambas vacías para no usar contraseña.</translation>
    </message>
    <message>
        <source>The two are not the same.</source>
        <translation>Las dos no coinciden.</translation>
    </message>
</context>
<context>
    <name>dialogs::AppearanceDialog</name>
    <message>
        <source>As the desktop</source>
        <translation>Como el escritorio</translation>
    </message>
    <message>
        <source>Language and look</source>
        <translation>Idioma y aspecto</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>As&amp;pecto</translation>
    </message>
    <message>
        <source>Words of the robot and text from the controller stay as they are on the pendant.</source>
        <translation>Las palabras del robot y los textos del controlador quedan como están en la consola de programación.</translation>
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
        <translation>Valor anterior</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Valor nuevo</translation>
    </message>
    <message>
        <source>Apply — %1</source>
        <translation>Aplicar — %1</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Lo que se escribirá</translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>Escribir %n valor</numerusform>
            <numerusform>Escribir %n valores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>Escribir %n valor en %1</numerusform>
            <numerusform>Escribir %n valores en %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Each is written once and read back. What does not read back as it was written stays here and is marked.</source>
        <translation>Cada valor se escribe una vez y se vuelve a leer. Lo que al volver a leerse no coincide con lo escrito permanece aquí y queda marcado.</translation>
    </message>
</context>
<context>
    <name>dialogs::CompareDialog</name>
    <message>
        <source>Both are the same, byte for byte.</source>
        <translation>Ambos son iguales, byte a byte.</translation>
    </message>
</context>
<context>
    <name>dialogs::ConnectionDialog</name>
    <message>
        <source>Duplicate</source>
        <translation>Duplicar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Connect to a controller</source>
        <translation>Conectar con un controlador</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Known controllers</source>
        <translation>Controladores conocidos</translation>
    </message>
    <message>
        <source>CONTROLLERS</source>
        <translation>CONTROLADORES</translation>
    </message>
    <message>
        <source>Connecting only reads. HOLD: Pause key.</source>
        <translation>Al conectar solo se lee. HOLD: tecla Pausa.</translation>
    </message>
    <message>
        <source>A motion limit must be a number above 0, and each side of the box must begin before it ends.</source>
        <translation>Un límite de movimiento debe ser un número mayor que 0, y cada lado de la caja límite debe empezar antes de terminar.</translation>
    </message>
    <message>
        <source>There is another controller with the name “%1”.</source>
        <translation>Ya hay otro controlador con el nombre “%1”.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>New controller</source>
        <translation>Controlador nuevo</translation>
    </message>
</context>
<context>
    <name>dialogs::DiagnosisDialog</name>
    <message>
        <source>Diagnosis — %1</source>
        <translation>Diagnóstico — %1</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>Copiar diagnóstico</translation>
    </message>
    <message>
        <source>The diagnosis is not finished yet.</source>
        <translation>El diagnóstico aún no ha terminado.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>It only reads. HOLD works meanwhile: Pause key.</source>
        <translation>Solo lee. HOLD sigue funcionando entretanto: tecla Pausa.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copiado</translation>
    </message>
</context>
<context>
    <name>dialogs::HelpDialog</name>
    <message>
        <source>Help — %1</source>
        <translation>Ayuda — %1</translation>
    </message>
    <message>
        <source>Search in this help</source>
        <translation>Buscar en esta ayuda</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Nada de lo que hay aquí contiene estas palabras.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Keys of this page</source>
        <translation>Teclas de esta página</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>Teclas en todas las páginas</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>Without a connection: connect to the controller on the filled button</source>
        <translation>Sin conexión: conectar con el controlador del botón relleno</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Live: read within its last three turns.</source>
        <translation>En vivo: leído en sus últimas tres rondas de lectura.</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>Desactualizado</translation>
    </message>
    <message>
        <source>Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.</source>
        <translation>Desactualizado: leído una vez, hace demasiado tiempo. La información emergente indica cuándo. No es lo que el robot hace ahora.</translation>
    </message>
    <message>
        <source>Unknown: not read on this connection. It is never shown as 0.</source>
        <translation>Desconocido: no leído en esta conexión. Nunca se muestra como 0.</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Rechazado</translation>
    </message>
    <message>
        <source>Refused: the controller does not tell it. The reason stands on the card or in the tool tip.</source>
        <translation>Rechazado: el controlador no lo comunica. El motivo figura en la tarjeta o en la información emergente.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activado</translation>
    </message>
    <message>
        <source>A filled square: on, or 1.</source>
        <translation>Un cuadrado relleno: activado, o 1.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>A hollow square: off, or 0.</source>
        <translation>Un cuadrado hueco: desactivado, o 0.</translation>
    </message>
    <message>
        <source>held</source>
        <translation>en HOLD</translation>
    </message>
    <message>
        <source>An amber triangle: error, hold, something not allowed or to be looked at.</source>
        <translation>Un triángulo ámbar: error, HOLD, algo no permitido o que se debe revisar.</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarma</translation>
    </message>
    <message>
        <source>A red square: an alarm.</source>
        <translation>Un cuadrado rojo: una alarma.</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>Qué significan los signos</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Ejemplo</translation>
    </message>
    <message>
        <source>An amber ground in a table: typed and staged, not sent yet. A red one: it reads back differently from what was written.</source>
        <translation>Fondo ámbar en una tabla: escrito y preparado, aún no enviado. Fondo rojo: al volver a leer, el valor es diferente del escrito.</translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message>
        <source>Take over values — %1</source>
        <translation>Adoptar valores — %1</translation>
    </message>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>Preparar %n valor</numerusform>
            <numerusform>Preparar %n valores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>Cambiaría %n valor</numerusform>
            <numerusform>Cambiarían %n valores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>%n valor ya está así. Al preparar no se envía nada al controlador.</numerusform>
            <numerusform>%n valores ya están así. Al preparar no se envía nada al controlador.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n línea no se puede leer, por lo que no se adopta nada:</numerusform>
            <numerusform>%n líneas no se pueden leer, por lo que no se adopta nada:</numerusform>
        </translation>
    </message>
    <message>
        <source>Lines that cannot be read</source>
        <translation>Líneas que no se pueden leer</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Qué está mal</translation>
    </message>
    <message>
        <source>Values that would change</source>
        <translation>Valores que cambiarían</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>Valor anterior</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Valor nuevo</translation>
    </message>
</context>
<context>
    <name>dialogs::IoWriteDialog</name>
    <message>
        <source>Write %1 — %2</source>
        <translation>Escribir %1 — %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>Será</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The eight signals #%1 to #%2 travel together: all of them are written as they stand here.</source>
        <translation>Las ocho señales de #%1 a #%2 se transmiten juntas: todas se escriben tal como están aquí.</translation>
    </message>
    <message>
        <source>The group is being read…</source>
        <translation>Leyendo el grupo…</translation>
    </message>
    <message>
        <source>Written once, then read back.</source>
        <translation>Se escribe una vez y luego se vuelve a leer.</translation>
    </message>
    <message>
        <source>Another of the eight has changed meanwhile. Nothing was sent: look again.</source>
        <translation>Entretanto ha cambiado otra de las ocho. No se envió nada: compruébelo de nuevo.</translation>
    </message>
    <message>
        <source>Being written…</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>Written, and read back as it was written.</source>
        <translation>Escrito y, al volver a leer, igual a lo escrito.</translation>
    </message>
    <message>
        <source>Accepted, but another value was read back: %1. Something else writes these signals.</source>
        <translation>Aceptado, pero al volver a leer se obtuvo otro valor: %1. Algo más escribe estas señales.</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Activar</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Desactivar</translation>
    </message>
</context>
<context>
    <name>dialogs::JobEditor</name>
    <message>
        <source>Edit “%1”</source>
        <translation>Editar “%1”</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>Texto del archivo</translation>
    </message>
    <message>
        <source>Compare and send…</source>
        <translation>Comparar y enviar…</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding lacks a character of this text.</source>
        <translation>La codificación del controlador carece de un carácter de este texto.</translation>
    </message>
</context>
<context>
    <name>dialogs::LadderView</name>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fallido</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>no alcanzado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Pendesk %1, diagnosis of %2 (%3)</source>
        <translation>Pendesk %1, diagnóstico de %2 (%3)</translation>
    </message>
</context>
<context>
    <name>dialogs::MotionForm</name>
    <message>
        <source>The tool point must stay in this box (base frame, mm)</source>
        <translation>El punto de herramienta debe permanecer en esta caja límite (sistema de coordenadas base, mm)</translation>
    </message>
    <message>
        <source>User and tool frames were checked on this robot</source>
        <translation>Los sistemas de coordenadas de usuario y de herramienta se comprobaron en este robot</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>Velocidad, mm/s</translation>
    </message>
    <message>
        <source>Rotation speed, °/s</source>
        <translation>Velocidad de rotación, °/s</translation>
    </message>
    <message>
        <source>Joint speed, %</source>
        <translation>Velocidad articular, %</translation>
    </message>
    <message>
        <source>Jog step, mm</source>
        <translation>Paso del movimiento manual, mm</translation>
    </message>
    <message>
        <source>Jog step, °</source>
        <translation>Paso del movimiento manual, °</translation>
    </message>
    <message>
        <source>Jog step, pulses</source>
        <translation>Paso del movimiento manual, pulsos</translation>
    </message>
    <message>
        <source>Descriptions disagree which code means the user and which the tool frame. Tick this only after a small move in both was watched at the robot.</source>
        <translation>Las descripciones no coinciden en qué código significa el sistema de coordenadas de usuario y cuál el de herramienta. Marque esta casilla solo después de haber observado en el robot un movimiento pequeño en ambos.</translation>
    </message>
    <message>
        <source>%1, as the program</source>
        <translation>%1, según el programa</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>Mínimo de %1</translation>
    </message>
    <message>
        <source>Most %1</source>
        <translation>Máximo de %1</translation>
    </message>
    <message>
        <source>%1 from, to</source>
        <translation>%1 desde, hasta</translation>
    </message>
</context>
<context>
    <name>dialogs::MoveSheet</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 pulsos</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Stop: HOLD</source>
        <translation>Parar: HOLD</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Move at %1</source>
        <translation>Mover en %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controlador</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>Grupo de control</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Caja límite</translation>
    </message>
    <message>
        <source>Stored points near the target</source>
        <translation>Puntos guardados cerca del destino</translation>
    </message>
    <message>
        <source>A long move, or one that nobody can measure: type %1</source>
        <translation>Un movimiento largo, o que nadie puede medir: escriba %1</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>Con el teclado: escriba %1 y pulse F9</translation>
    </message>
    <message>
        <source>HOLD stays on until it is released</source>
        <translation>HOLD permanece activado hasta que se libere</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>El robot se moverá</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>cannot be foretold in this frame</source>
        <translation>no se puede predecir en este sistema de coordenadas</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>aprox. %1 s</translation>
    </message>
    <message>
        <source>not known: a percentage of joint speed</source>
        <translation>desconocido: un porcentaje de la velocidad articular</translation>
    </message>
    <message>
        <source>not known: the target is in pulses</source>
        <translation>desconocido: el destino está en pulsos</translation>
    </message>
    <message>
        <source>%1 mm and %2° between the ends; a joint move does not go straight</source>
        <translation>%1 mm y %2° entre los extremos; un movimiento articular no va en línea recta</translation>
    </message>
    <message>
        <source>%1 mm straight, turning %2°</source>
        <translation>%1 mm en línea recta, con un giro de %2°</translation>
    </message>
    <message>
        <source>none is set for this controller</source>
        <translation>no hay ninguna definida para este controlador</translation>
    </message>
    <message>
        <source>the whole way is inside</source>
        <translation>todo el recorrido está dentro</translation>
    </message>
    <message>
        <source>both ends are inside; the way between is not known</source>
        <translation>ambos extremos están dentro; el recorrido entre ellos no se conoce</translation>
    </message>
    <message>
        <source>%1, at most %2 %</source>
        <translation>%1, como máximo %2 %</translation>
    </message>
    <message>
        <source>%1, at most %2 mm/s</source>
        <translation>%1, como máximo %2 mm/s</translation>
    </message>
    <message>
        <source>%1, at most %2 °/s</source>
        <translation>%1, como máximo %2 °/s</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>no se puede comparar</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 a %2 mm</translation>
    </message>
    <message>
        <source>none in the base frame was read</source>
        <translation>no se leyó ninguno en el sistema de coordenadas base</translation>
    </message>
    <message>
        <source>The robot is no longer where this move begins: close, and rehearse again.</source>
        <translation>El robot ya no está donde empieza este movimiento: cierre y repita la comprobación previa.</translation>
    </message>
    <message>
        <source>Not sent: the place could not be read.</source>
        <translation>No enviado: no se pudo leer la posición.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>a place that was not read</source>
        <translation>una posición que no se leyó</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>En curso: %1</translation>
    </message>
    <message>
        <source>Move sent…</source>
        <translation>Movimiento enviado…</translation>
    </message>
    <message>
        <source>Arrived: %1</source>
        <translation>Ha llegado: %1</translation>
    </message>
    <message>
        <source>Stopped at %1. That is not the target.</source>
        <translation>Parado en %1. Ese no es el destino.</translation>
    </message>
    <message>
        <source>At rest at %1. Whether that is the target cannot be told in this frame.</source>
        <translation>En reposo en %1. En este sistema de coordenadas no se puede saber si ese es el destino.</translation>
    </message>
    <message>
        <source>No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.</source>
        <translation>Sin respuesta al movimiento: se desconoce si comenzó. Se envió una vez. Observe el robot.</translation>
    </message>
    <message>
        <source>The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.</source>
        <translation>El resultado es desconocido: se perdió la comunicación o el robot no queda en reposo. Observe el robot.</translation>
    </message>
</context>
<context>
    <name>dialogs::NumberingDialog</name>
    <message>
        <source>Variable numbering — %1</source>
        <translation>Numeración de variables — %1</translation>
    </message>
    <message>
        <source>Number of the variable</source>
        <translation>Número de la variable</translation>
    </message>
    <message>
        <source>Value on the pendant</source>
        <translation>Valor en la consola de programación</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>aún no leída</translation>
    </message>
    <message>
        <source>reads on the pendant</source>
        <translation>tiene en la consola de programación</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>Conservar el resultado</translation>
    </message>
    <message>
        <source>Which number is which?</source>
        <translation>¿Qué número es cuál?</translation>
    </message>
    <message>
        <source>Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) and enter what you see. This test only reads.</source>
        <translation>El parámetro RS022 decide si B000 es el número 0 o el número 1 en la red. Mientras no se sepa, una escritura podría afectar a la variable vecina; por eso no se envía ninguna. Lea dos variables en la consola de programación (menú principal, VARIABLE, BYTE) e introduzca lo que vea. Esta prueba solo lee.</translation>
    </message>
    <message>
        <source>The variables could not be read: %1.</source>
        <translation>No se pudieron leer las variables: %1.</translation>
    </message>
    <message>
        <source>All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 and B011 to 2, then open this test again.</source>
        <translation>Todas las variables B tienen el mismo valor, lo que no demuestra nada: ponga B010 a 1 y B011 a 2 mediante un trabajo o en la consola de programación y vuelva a abrir esta prueba.</translation>
    </message>
    <message>
        <source>These two tell the numberings apart.</source>
        <translation>Estas dos permiten distinguir las numeraciones.</translation>
    </message>
    <message>
        <source>Verified: number 0 on the network is B000.</source>
        <translation>Verificado: el número 0 en la red es B000.</translation>
    </message>
    <message>
        <source>Verified, shifted: number 1 on the network is B000.</source>
        <translation>Verificado, desplazado: el número 1 en la red es B000.</translation>
    </message>
    <message>
        <source>Both numberings fit these values: choose variables whose neighbours hold other values.</source>
        <translation>Ambas numeraciones concuerdan con estos valores: elija variables cuyas vecinas tengan otros valores.</translation>
    </message>
    <message>
        <source>Neither numbering fits: read the values again, they may have changed.</source>
        <translation>Ninguna numeración concuerda: vuelva a leer los valores, pueden haber cambiado.</translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>También para el %n archivo restante</numerusform>
            <numerusform>También para los %n archivos restantes</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” exists</source>
        <translation>“%1” ya existe</translation>
    </message>
    <message>
        <source>There is a file “%1” %2 already.</source>
        <translation>Ya hay un archivo “%1” %2.</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>&amp;Comparar…</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>&amp;Keep both</source>
        <translation>Conservar &amp;ambos</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Omitir</translation>
    </message>
</context>
<context>
    <name>dialogs::PasscodeDialog</name>
    <message>
        <source>The passcode guards against mistakes, not against attackers: whoever can change this user&apos;s files can remove it.</source>
        <translation>La contraseña protege contra errores, no contra ataques: quien pueda modificar los archivos de este usuario puede quitarla.</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>Nivel de acceso: %1</translation>
    </message>
    <message>
        <source>Passcode</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>That is not the passcode.</source>
        <translation>Esa no es la contraseña.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Comprobando…</translation>
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
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Preparar</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 o %2</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>Sistema de coordenadas de usuario</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>Forma ampliada</translation>
    </message>
    <message>
        <source>Take the present position of R1 (base frame)</source>
        <translation>Tomar la posición actual de R1 (sistema de coordenadas base)</translation>
    </message>
    <message>
        <source>Take R1 in pulses</source>
        <translation>Tomar R1 en pulsos</translation>
    </message>
    <message>
        <source>Take the present position of B1 (base frame)</source>
        <translation>Tomar la posición actual de B1 (sistema de coordenadas base)</translation>
    </message>
    <message>
        <source>Take B1 in pulses</source>
        <translation>Tomar B1 en pulsos</translation>
    </message>
    <message>
        <source>Take the present position of S1</source>
        <translation>Tomar la posición actual de S1</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>en vivo: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A user-frame position needs a user frame from 1 to 63.</source>
        <translation>Una posición en coordenadas de usuario necesita un sistema de coordenadas de usuario de 1 a 63.</translation>
    </message>
    <message>
        <source>Sources disagree which code means user and which means tool frame: check on the pendant before a job uses this position.</source>
        <translation>Las fuentes no coinciden en qué código significa el sistema de coordenadas de usuario y cuál el de herramienta: compruébelo en la consola de programación antes de que un trabajo utilice esta posición.</translation>
    </message>
    <message>
        <source>The position is being read…</source>
        <translation>Leyendo la posición…</translation>
    </message>
    <message>
        <source>The position could not be read: %1.</source>
        <translation>No se pudo leer la posición: %1.</translation>
    </message>
</context>
<context>
    <name>dialogs::ProfileForm</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Host name or address</source>
        <translation>Nombre de host o dirección</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Text encoding</source>
        <translation>Codificación de texto</translation>
    </message>
    <message>
        <source>Variable numbering</source>
        <translation>Numeración de variables</translation>
    </message>
    <message>
        <source>B000 is number 0 on the wire</source>
        <translation>B000 es el número 0 en la red</translation>
    </message>
    <message>
        <source>B000 is number 1 on the wire</source>
        <translation>B000 es el número 1 en la red</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Puerto de archivos</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>Tiempo límite de lectura</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>Tiempo límite de archivos</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>Tiempo límite del servo</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>Repeticiones de una lectura</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>Solicitudes pendientes a la vez</translation>
    </message>
    <message>
        <source>Requests a second, at most</source>
        <translation>Solicitudes por segundo, como máximo</translation>
    </message>
    <message>
        <source>Jog and move, at most</source>
        <translation>Movimiento manual y mover, como máximo</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>De %1 a %2</translation>
    </message>
</context>
<context>
    <name>dialogs::ReadinessSheet</name>
    <message>
        <source>Readiness — %1</source>
        <translation>Disponibilidad — %1</translation>
    </message>
    <message>
        <source>What %1 allows now</source>
        <translation>Qué permite ahora %1</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Disponibilidad</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the readiness and a diagnosis</source>
        <translation>Copiar la disponibilidad y un diagnóstico</translation>
    </message>
    <message>
        <source>As text for support, with a diagnosis of the link, which takes a moment.</source>
        <translation>Como texto para el servicio de asistencia, con un diagnóstico del enlace, que tarda un momento.</translation>
    </message>
    <message>
        <source>Test numbering…</source>
        <translation>Probar la numeración…</translation>
    </message>
    <message>
        <source>It needs a link to the controller.</source>
        <translation>Se necesita un enlace con el controlador.</translation>
    </message>
    <message>
        <source>Communication lost at %1: what is hatched was read before.</source>
        <translation>Comunicación perdida a las %1: lo que aparece rayado se leyó antes.</translation>
    </message>
    <message>
        <source>%1 has not answered yet.</source>
        <translation>%1 aún no ha respondido.</translation>
    </message>
    <message>
        <source>Not connected: nothing is read.</source>
        <translation>No conectado: no se lee nada.</translation>
    </message>
    <message>
        <source>The status was not read just now.</source>
        <translation>El estado no se ha leído recientemente.</translation>
    </message>
    <message>
        <source>It is read live and changes nothing. HOLD works meanwhile: Pause key.</source>
        <translation>Se lee en vivo y no cambia nada. HOLD sigue funcionando entretanto: tecla Pausa.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copiado</translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message>
        <source>Put that file back</source>
        <translation>Reponer ese archivo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Restore %1 from %2</source>
        <translation>Restaurar %1 desde %2</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>Lo que se haría</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>Lo que se hace</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>+ new: it is sent</source>
        <translation>+ nuevo: se envía</translation>
    </message>
    <message>
        <source>≠ changed: it is replaced</source>
        <translation>≠ modificado: se reemplaza</translation>
    </message>
    <message>
        <source>= same: left alone</source>
        <translation>= igual: no se toca</translation>
    </message>
    <message>
        <source>▲ not allowed: left alone</source>
        <translation>▲ no permitido: no se toca</translation>
    </message>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>Hacer copia de seguridad y restaurar %n archivo</numerusform>
            <numerusform>Hacer copia de seguridad y restaurar %n archivos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>%n archivo es igual y no aparece en la lista.</numerusform>
            <numerusform>%n archivos son iguales y no aparecen en la lista.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Sending file %1 of %2…</source>
        <translation>Enviando el archivo %1 de %2…</translation>
    </message>
    <message>
        <source>Fresh backup: file %1 of %2…</source>
        <translation>Copia de seguridad nueva: archivo %1 de %2…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>%n archivo se restauró y se volvió a leer.</numerusform>
            <numerusform>%n archivos se restauraron y se volvieron a leer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>Antes se restauró %n archivo.</numerusform>
            <numerusform>Antes se restauraron %n archivos.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>Se canceló.</translation>
    </message>
    <message>
        <source>Stopped at %1.</source>
        <translation>Detenido en %1.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>No se envió nada.</translation>
    </message>
    <message>
        <source>The file is as it was before.</source>
        <translation>El archivo está como antes.</translation>
    </message>
    <message>
        <source>▲ The file could not be put back. Look at the controller.</source>
        <translation>▲ No se pudo reponer el archivo. Compruebe el controlador.</translation>
    </message>
    <message>
        <source>A fresh backup of %1 is made first. Then the files below are sent one by one and read back. A refused file is left out; it stops at any other error.</source>
        <translation>Primero se hace una copia de seguridad nueva de %1. Después, los archivos siguientes se envían uno a uno y se vuelven a leer. Un archivo rechazado se omite; con cualquier otro error se detiene.</translation>
    </message>
    <message>
        <source>%1: the backup is of %2, the controller is %3.</source>
        <translation>%1: la copia de seguridad es de %2, el controlador es %3.</translation>
    </message>
    <message>
        <source>This is the backup of another robot: nothing of it is sent.</source>
        <translation>Esta es la copia de seguridad de otro robot: no se envía nada de ella.</translation>
    </message>
    <message>
        <source>The controller refused %1; the other files were sent.</source>
        <translation>El controlador rechazó %1; los demás archivos se enviaron.</translation>
    </message>
</context>
<context>
    <name>dialogs::SignalPicker</name>
    <message>
        <source>Add a signal</source>
        <translation>Añadir una señal</translation>
    </message>
    <message>
        <source>For example: R1 torque, B005, #00010, M012</source>
        <translation>Por ejemplo: R1 par, B005, #00010, M012</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>dialogs::StartSheet</name>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Start at %1</source>
        <translation>Iniciar en %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controlador</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>Desde la línea</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Override de velocidad</translation>
    </message>
    <message>
        <source>HOLD: Pause key</source>
        <translation>HOLD: tecla Pausa</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>El robot se moverá</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>Con el teclado: escriba %1 y pulse F9</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Start sent…</source>
        <translation>Inicio enviado…</translation>
    </message>
    <message>
        <source>Accepted. Waiting for RUN…</source>
        <translation>Aceptado. Esperando RUN…</translation>
    </message>
    <message>
        <source>The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.</source>
        <translation>El inicio se aceptó, pero no se vio RUN durante 3 s. Causas habituales: el trabajo era tan corto que ya ha terminado, espera una condición de la celda o la consola de programación muestra una pregunta. Mire la consola de programación.</translation>
    </message>
    <message>
        <source>No answer to the start: it may or may not have happened. Reading the status…</source>
        <translation>Sin respuesta al inicio: puede haberse ejecutado o no. Leyendo el estado…</translation>
    </message>
    <message>
        <source>No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.</source>
        <translation>Sin respuesta al inicio ni a la consulta de estado: se desconoce si el robot está en marcha. Obsérvelo.</translation>
    </message>
    <message>
        <source>No answer to the start, but a status that was read afterwards said RUN. It was sent once.</source>
        <translation>Sin respuesta al inicio, pero un estado leído después indicaba RUN. Se envió una sola vez.</translation>
    </message>
    <message>
        <source>No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you start again.</source>
        <translation>Sin respuesta al inicio, y un estado leído después no indicaba RUN. Observe el robot antes de iniciar de nuevo.</translation>
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
        <translation>Condiciones</translation>
    </message>
    <message>
        <source>What must be the case</source>
        <translation>Lo que debe cumplirse</translation>
    </message>
</context>
<context>
    <name>files::Identity</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Robots and axes</source>
        <translation>Robots y ejes</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Number of variables</source>
        <translation>Número de variables</translation>
    </message>
</context>
<context>
    <name>files::Restore</name>
    <message>
        <source>It is not in the backup.</source>
        <translation>No está en la copia de seguridad.</translation>
    </message>
    <message>
        <source>What the controller has could not be read.</source>
        <translation>No se pudo leer lo que tiene el controlador.</translation>
    </message>
    <message>
        <source>In the backup it is not as it was written.</source>
        <translation>En la copia de seguridad no está tal como se escribió.</translation>
    </message>
    <message>
        <source>It belongs to this one controller, or only tells what happened: it is never sent.</source>
        <translation>Pertenece solo a este controlador, o únicamente cuenta lo que ocurrió: no se envía nunca.</translation>
    </message>
    <message>
        <source>It comes from another robot.</source>
        <translation>Procede de otro robot.</translation>
    </message>
    <message>
        <source>It changes how the robot moves, or what protects people: look at the differences and choose it.</source>
        <translation>Cambia cómo se mueve el robot o lo que protege a las personas: revise las diferencias y elíjalo.</translation>
    </message>
</context>
<context>
    <name>files::Verify</name>
    <message>
        <source>This is no backup: %1 is missing or of another kind.</source>
        <translation>Esto no es una copia de seguridad: %1 falta o es de otro tipo.</translation>
    </message>
    <message>
        <source>%1 is not as it was written.</source>
        <translation>%1 no está tal como se escribió.</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 se modificó.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>Falta %1.</translation>
    </message>
    <message>
        <source>%1 does not belong to the backup.</source>
        <translation>%1 no pertenece a la copia de seguridad.</translation>
    </message>
</context>
<context>
    <name>inform::Check</name>
    <message>
        <source>The file is empty.</source>
        <translation>El archivo está vacío.</translation>
    </message>
    <message>
        <source>HSES cannot carry it.</source>
        <translation>HSES no puede transmitirlo.</translation>
    </message>
    <message>
        <source>“%1” is no type of file that can be sent.</source>
        <translation>“%1” no es un tipo de archivo que se pueda enviar.</translation>
    </message>
    <message>
        <source>Controllers take JBI, JBR, CND, DAT, PRM and LST.</source>
        <translation>Los controladores aceptan JBI, JBR, CND, DAT, PRM y LST.</translation>
    </message>
    <message>
        <source>The type of the file is written in small letters.</source>
        <translation>El tipo del archivo está escrito en minúsculas.</translation>
    </message>
    <message>
        <source>Controllers write it in capitals.</source>
        <translation>Los controladores lo escriben en mayúsculas.</translation>
    </message>
    <message>
        <source>The header names the job “%1”.</source>
        <translation>El encabezado nombra el trabajo “%1”.</translation>
    </message>
    <message>
        <source>The name in the header counts: that job would be written.</source>
        <translation>Cuenta el nombre del encabezado: se escribiría ese trabajo.</translation>
    </message>
    <message>
        <source>The job is being executed.</source>
        <translation>El trabajo se está ejecutando.</translation>
    </message>
    <message>
        <source>A running job cannot be replaced.</source>
        <translation>Un trabajo en marcha no se puede reemplazar.</translation>
    </message>
    <message>
        <source>All names in the controller become those in this file.</source>
        <translation>Todos los nombres del controlador pasan a ser los de este archivo.</translation>
    </message>
    <message>
        <source>Back them up first.</source>
        <translation>Haga antes una copia.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark.</source>
        <translation>El archivo empieza con una marca de orden de bytes.</translation>
    </message>
    <message>
        <source>Controllers know no such mark: save the file without it.</source>
        <translation>Los controladores no conocen esa marca: guarde el archivo sin ella.</translation>
    </message>
    <message>
        <source>The file is UTF-16 text.</source>
        <translation>El archivo es texto UTF-16.</translation>
    </message>
    <message>
        <source>Controllers take one byte for a letter.</source>
        <translation>Los controladores usan un byte por letra.</translation>
    </message>
    <message>
        <source>The lines end in CR alone.</source>
        <translation>Las líneas acaban solo en CR.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).</source>
        <translation>Las líneas terminan en CR LF; el controlador no encuentra ni NOP ni END (consola 3200).</translation>
    </message>
    <message>
        <source>Lines end in LF alone.</source>
        <translation>Las líneas acaban solo en LF.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).</source>
        <translation>Las líneas terminan en CR LF; el controlador no encuentra ni NOP ni END (0x5130, consola 3200).</translation>
    </message>
    <message>
        <source>Lines end in CR LF; a controller may read such a file as empty.</source>
        <translation>Las líneas terminan en CR LF; un controlador puede leer un archivo así como vacío.</translation>
    </message>
    <message>
        <source>The last line does not end.</source>
        <translation>La última línea no tiene fin de línea.</translation>
    </message>
    <message>
        <source>Controllers end each line in CR LF.</source>
        <translation>Los controladores terminan cada línea en CR LF.</translation>
    </message>
    <message>
        <source>There is a Ctrl-Z at the end.</source>
        <translation>Hay un Ctrl-Z al final.</translation>
    </message>
    <message>
        <source>It stands behind END, which must be last (0x5130).</source>
        <translation>Está detrás de END, que debe ser lo último (0x5130).</translation>
    </message>
    <message>
        <source>There is a control character.</source>
        <translation>Hay un carácter de control.</translation>
    </message>
    <message>
        <source>No line of a job may have one.</source>
        <translation>Ninguna línea de un trabajo puede tenerlo.</translation>
    </message>
    <message>
        <source>This is no job: it does not have the line /JOB.</source>
        <translation>Esto no es un trabajo: no tiene la línea /JOB.</translation>
    </message>
    <message>
        <source>A job begins with it (0x5310).</source>
        <translation>Un trabajo empieza con ella (0x5310).</translation>
    </message>
    <message>
        <source>The file holds more than one job.</source>
        <translation>El archivo contiene más de un trabajo.</translation>
    </message>
    <message>
        <source>Only the first one was looked at.</source>
        <translation>Solo se examinó el primero.</translation>
    </message>
    <message>
        <source>“%1” is no name for a job.</source>
        <translation>“%1” no es un nombre de trabajo.</translation>
    </message>
    <message>
        <source>A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).</source>
        <translation>Un nombre tiene de 1 a 32 bytes, sin espacios ni los signos que los nombres de archivo no pueden tener (0x4190).</translation>
    </message>
    <message>
        <source>There is text that belongs to no section.</source>
        <translation>Hay texto que no pertenece a ninguna sección.</translation>
    </message>
    <message>
        <source>It is no INFORM (0x5310).</source>
        <translation>No es INFORM (0x5310).</translation>
    </message>
    <message>
        <source>%1 is no known pseudo instruction.</source>
        <translation>%1 no es una pseudoinstrucción conocida.</translation>
    </message>
    <message>
        <source>A controller that does not know it refuses the file (0x5340).</source>
        <translation>Un controlador que no la conoce rechaza el archivo (0x5340).</translation>
    </message>
    <message>
        <source>The comment of the job is longer than 32 bytes.</source>
        <translation>El comentario del trabajo tiene más de 32 bytes.</translation>
    </message>
    <message>
        <source>Controllers cut it or refuse it.</source>
        <translation>Los controladores lo cortan o lo rechazan.</translation>
    </message>
    <message>
        <source>A frame is given, and the attribute RJ is missing.</source>
        <translation>Se indica un sistema de coordenadas y falta el atributo RJ.</translation>
    </message>
    <message>
        <source>Only relative jobs have a frame (0x4490).</source>
        <translation>Solo los trabajos relativos lo tienen (0x4490).</translation>
    </message>
    <message>
        <source>The job is relative, and no frame is given.</source>
        <translation>El trabajo es relativo y no indica sistema de coordenadas.</translation>
    </message>
    <message>
        <source>A relative job names its frame (0x3390).</source>
        <translation>Un trabajo relativo nombra el suyo (0x3390).</translation>
    </message>
    <message>
        <source>There are positions, and no ///NPOS that counts them.</source>
        <translation>Hay posiciones, y no hay ningún ///NPOS que las cuente.</translation>
    </message>
    <message>
        <source>The controller compares them (0x5180).</source>
        <translation>El controlador los compara (0x5180).</translation>
    </message>
    <message>
        <source>///NPOS does not count the positions of each kind: %1 (kind, said, found).</source>
        <translation>///NPOS no cuenta las posiciones de cada tipo: %1 (tipo, indicadas, halladas).</translation>
    </message>
    <message>
        <source>There is text among the positions that is none.</source>
        <translation>Entre las posiciones hay texto que no es una posición.</translation>
    </message>
    <message>
        <source>Every line of //POS is a position or a pseudo instruction (0x5120).</source>
        <translation>Cada línea de //POS es una posición o una pseudoinstrucción (0x5120).</translation>
    </message>
    <message>
        <source>%1 is there twice.</source>
        <translation>%1 aparece dos veces.</translation>
    </message>
    <message>
        <source>Each position has one entry (0x5120).</source>
        <translation>Cada posición tiene una sola entrada (0x5120).</translation>
    </message>
    <message>
        <source>%1 is named by no line.</source>
        <translation>Ninguna línea nombra %1.</translation>
    </message>
    <message>
        <source>Each taught point belongs to one instruction (pendant 3190).</source>
        <translation>Cada punto enseñado pertenece a una instrucción (consola 3190).</translation>
    </message>
    <message>
        <source>%1 has no entry among the positions.</source>
        <translation>%1 no tiene entrada entre las posiciones.</translation>
    </message>
    <message>
        <source>The robot would not know where to go (0x4130).</source>
        <translation>El robot no sabría adónde ir (0x4130).</translation>
    </message>
    <message>
        <source>%1 is named in two places.</source>
        <translation>%1 se nombra en dos lugares.</translation>
    </message>
    <message>
        <source>Controllers give each place a point of its own.</source>
        <translation>Los controladores dan a cada lugar un punto propio.</translation>
    </message>
    <message>
        <source>The number of values does not fit the axes: %1 (position, values).</source>
        <translation>El número de valores no corresponde a los ejes: %1 (posición, valores).</translation>
    </message>
    <message>
        <source>A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).</source>
        <translation>Un robot tiene 6 o 7 ejes, una base de 1 a 3, una estación de 1 a 6 (0x5180).</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1 tiene un valor que no es un número.</translation>
    </message>
    <message>
        <source>The controller cannot read it (0x5120).</source>
        <translation>El controlador no puede leerlo (0x5120).</translation>
    </message>
    <message>
        <source>The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE.</source>
        <translation>La línea ///PULSE, ///RECTAN o ///ANGLE anterior a %1 no corresponde a su ///POSTYPE.</translation>
    </message>
    <message>
        <source>PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).</source>
        <translation>PULSE va con ///PULSE, ANGLE con ///ANGLE, los demás con ///RECTAN (0x5120).</translation>
    </message>
    <message>
        <source>%1 is in pulses, and the job is relative.</source>
        <translation>%1 está en pulsos, y el trabajo es relativo.</translation>
    </message>
    <message>
        <source>The points of a relative job stand in its frame.</source>
        <translation>Los puntos de un trabajo relativo están en su sistema de coord.</translation>
    </message>
    <message>
        <source>There are taught points (%1), and the job has no control group.</source>
        <translation>Hay puntos enseñados (%1), y el trabajo no tiene grupo de control.</translation>
    </message>
    <message>
        <source>A job without a group cannot move (0x5430).</source>
        <translation>Un trabajo sin grupo no puede mover nada (0x5430).</translation>
    </message>
    <message>
        <source>There are %1 points, and no control group of the job has such axes.</source>
        <translation>Hay puntos %1, y ningún grupo de control del trabajo tiene esos ejes.</translation>
    </message>
    <message>
        <source>C needs a robot, BC a base, EC a station among the groups (0x3370).</source>
        <translation>C necesita un robot, BC una base y EC una estación entre los grupos (0x3370).</translation>
    </message>
    <message>
        <source>The first instruction is not NOP.</source>
        <translation>La primera instrucción no es NOP.</translation>
    </message>
    <message>
        <source>Every job begins with NOP (0x5130, pendant 3200).</source>
        <translation>Todo trabajo empieza con NOP (0x5130, consola 3200).</translation>
    </message>
    <message>
        <source>The last instruction is not END.</source>
        <translation>La última instrucción no es END.</translation>
    </message>
    <message>
        <source>Every job ends with END (0x5130, pendant 3200).</source>
        <translation>Todo trabajo termina con END (0x5130, consola 3200).</translation>
    </message>
    <message>
        <source>There is an END before the last line.</source>
        <translation>Hay un END antes de la última línea.</translation>
    </message>
    <message>
        <source>What follows it is no job (0x5130).</source>
        <translation>Lo que le sigue no es un trabajo (0x5130).</translation>
    </message>
    <message>
        <source>The line begins with no instruction.</source>
        <translation>La línea no empieza con ninguna instrucción.</translation>
    </message>
    <message>
        <source>An instruction was cut in two: it belongs to the line before (0x5110).</source>
        <translation>Una instrucción se cortó en dos: pertenece a la línea anterior (0x5110).</translation>
    </message>
    <message>
        <source>%1 is no instruction that this program knows.</source>
        <translation>%1 no es una instrucción que este programa conozca.</translation>
    </message>
    <message>
        <source>It may belong to an option; a controller without it refuses the job (0x5110).</source>
        <translation>Puede pertenecer a una opción; un controlador sin ella rechaza el trabajo (0x5110).</translation>
    </message>
    <message>
        <source>There are characters beyond ASCII outside of comments and texts.</source>
        <translation>Hay caracteres no ASCII fuera de comentarios y textos.</translation>
    </message>
    <message>
        <source>Instructions are ASCII.</source>
        <translation>Las instrucciones son ASCII.</translation>
    </message>
    <message>
        <source>There is an empty line among the instructions.</source>
        <translation>Hay una línea vacía entre las instrucciones.</translation>
    </message>
    <message>
        <source>Controllers write none.</source>
        <translation>El controlador no las escribe.</translation>
    </message>
    <message>
        <source>The job has more than 10,000 lines.</source>
        <translation>El trabajo tiene más de 10.000 líneas.</translation>
    </message>
    <message>
        <source>Controllers number lines to 9999.</source>
        <translation>Los controladores numeran líneas hasta 9999.</translation>
    </message>
    <message>
        <source>A comment or message is longer than 32 bytes.</source>
        <translation>Un comentario o mensaje tiene más de 32 bytes.</translation>
    </message>
    <message>
        <source>Controllers cut it.</source>
        <translation>El controlador lo corta.</translation>
    </message>
    <message>
        <source>The label *%1 is longer than 8 bytes.</source>
        <translation>La etiqueta *%1 tiene más de 8 bytes.</translation>
    </message>
    <message>
        <source>Labels have 1 to 8 (0x4200).</source>
        <translation>Las etiquetas tienen de 1 a 8 (0x4200).</translation>
    </message>
    <message>
        <source>The label *%1 is there twice.</source>
        <translation>La etiqueta *%1 aparece dos veces.</translation>
    </message>
    <message>
        <source>A jump would have two goals (0x4200).</source>
        <translation>Un salto tendría dos destinos (0x4200).</translation>
    </message>
    <message>
        <source>There is no label *%1.</source>
        <translation>No existe la etiqueta *%1.</translation>
    </message>
    <message>
        <source>The jump gives an alarm when it is executed.</source>
        <translation>El salto produce una alarma al ejecutarse.</translation>
    </message>
    <message>
        <source>%1 is not closed.</source>
        <translation>%1 no está cerrado.</translation>
    </message>
    <message>
        <source>IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</source>
        <translation>IFTHEN necesita ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</translation>
    </message>
    <message>
        <source>%1 stands outside of what it belongs to.</source>
        <translation>%1 está fuera de la estructura a la que pertenece.</translation>
    </message>
    <message>
        <source>Structures are closed in the reverse order (0x5110).</source>
        <translation>Las estructuras se cierran en orden inverso (0x5110).</translation>
    </message>
    <message>
        <source>Structures are nested more than 10 deep.</source>
        <translation>Las estructuras tienen más de 10 niveles de anidamiento.</translation>
    </message>
    <message>
        <source>Controllers allow 10.</source>
        <translation>Se permiten 10.</translation>
    </message>
    <message>
        <source>%1 is out of range.</source>
        <translation>%1 está fuera de rango.</translation>
    </message>
    <message>
        <source>The controller may refuse it (0x5200).</source>
        <translation>El controlador puede rechazarlo (0x5200).</translation>
    </message>
    <message>
        <source>There are more than 8 arguments.</source>
        <translation>Hay más de 8 argumentos.</translation>
    </message>
    <message>
        <source>A job takes 8 (0x5110).</source>
        <translation>Un trabajo admite 8 (0x5110).</translation>
    </message>
    <message>
        <source>%1 is beyond what ///LVARS provides.</source>
        <translation>%1 excede lo que ///LVARS prevé.</translation>
    </message>
    <message>
        <source>The job has fewer local variables (0x5110).</source>
        <translation>El trabajo tiene menos variables locales (0x5110).</translation>
    </message>
    <message>
        <source>Line %1 of the file, named by line %2: %3</source>
        <translation>Línea %1 del archivo, nombrada por la línea %2: %3</translation>
    </message>
    <message>
        <source>Line %1 (%2 in the file): %3</source>
        <translation>Línea %1 (%2 en el archivo): %3</translation>
    </message>
    <message>
        <source>Line %1 of the file: %2</source>
        <translation>Línea %1 del archivo: %2</translation>
    </message>
    <message>
        <source>There is no ///NPOS.</source>
        <translation>No hay ///NPOS.</translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message>
        <source>arm form: field %1 of RCONF %2 → %3</source>
        <translation>forma del brazo: campo %1 de RCONF %2 → %3</translation>
    </message>
    <message>
        <source>arm form: %1 → %2</source>
        <translation>forma del brazo: %1 → %2</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>%1 pulses in %2</source>
        <translation>%1 pulsos en %2</translation>
    </message>
    <message>
        <source>%1 mm in %2</source>
        <translation>%1 mm en %2</translation>
    </message>
    <message>
        <source>%1° in %2</source>
        <translation>%1° en %2</translation>
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
        <translation>%1 en total</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>desplazado %1</translation>
    </message>
    <message>
        <source>moved %1 (%2)</source>
        <translation>desplazado %1 (%2)</translation>
    </message>
    <message>
        <source>type %1 → %2</source>
        <translation>tipo %1 → %2</translation>
    </message>
    <message>
        <source>tool %1 → %2</source>
        <translation>herramienta %1 → %2</translation>
    </message>
    <message>
        <source>user frame %1 → %2</source>
        <translation>sist. de usuario %1 → %2</translation>
    </message>
    <message>
        <source>marked as beyond the limit</source>
        <translation>marcado como fuera del límite</translation>
    </message>
    <message>
        <source>no longer marked as beyond the limit</source>
        <translation>ya no marcado como fuera del límite</translation>
    </message>
    <message>
        <source>values %1 → %2</source>
        <translation>valores %1 → %2</translation>
    </message>
    <message>
        <source>Made a relative job</source>
        <translation>Ahora es trabajo relativo</translation>
    </message>
    <message>
        <source>No longer a relative job</source>
        <translation>Ya no es un trabajo relativo</translation>
    </message>
    <message>
        <source>The job is locked against editing</source>
        <translation>El trabajo está bloqueado contra edición</translation>
    </message>
    <message>
        <source>The job is no longer locked against editing</source>
        <translation>El trabajo ya no está bloqueado contra edición</translation>
    </message>
    <message>
        <source>Made a macro job</source>
        <translation>Ahora es trabajo macro</translation>
    </message>
    <message>
        <source>No longer a macro job</source>
        <translation>Ya no es un trabajo macro</translation>
    </message>
    <message>
        <source>Attribute %1 added</source>
        <translation>Atributo %1 añadido</translation>
    </message>
    <message>
        <source>Attribute %1 removed</source>
        <translation>Atributo %1 eliminado</translation>
    </message>
    <message>
        <source>Relative frame %1 added</source>
        <translation>Sistema relativo %1 añadido</translation>
    </message>
    <message>
        <source>Relative frame %1 removed</source>
        <translation>Sistema relativo %1 eliminado</translation>
    </message>
    <message>
        <source>Relative frame: %1 → %2</source>
        <translation>Sistema relativo: %1 → %2</translation>
    </message>
    <message>
        <source>Job name: “%1” → “%2”</source>
        <translation>Nombre de trabajo: “%1” → “%2”</translation>
    </message>
    <message>
        <source>Job folder: “%1” → “%2”</source>
        <translation>Carpeta del trabajo: “%1” → “%2”</translation>
    </message>
    <message>
        <source>Comment of the job: “%1” → “%2”</source>
        <translation>Comentario del trabajo: “%1” → “%2”</translation>
    </message>
    <message>
        <source>Control group GROUP%1: %2 → %3</source>
        <translation>Grupo de control GROUP%1: %2 → %3</translation>
    </message>
    <message>
        <source>Control group GROUP%1 added: %2</source>
        <translation>Grupo de control GROUP%1 añadido: %2</translation>
    </message>
    <message>
        <source>Control group GROUP%1 removed: %2</source>
        <translation>Grupo de control GROUP%1 eliminado: %2</translation>
    </message>
    <message>
        <source>Local variables %1: %2 → %3</source>
        <translation>Variables locales %1: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1: %2 → %3</source>
        <translation>Alias de %1: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1 added: %2</source>
        <translation>Alias de %1 añadido: %2</translation>
    </message>
    <message>
        <source>Alias of %1 removed: %2</source>
        <translation>Alias de %1 eliminado: %2</translation>
    </message>
    <message>
        <source>Argument %1: “%2” → “%3”</source>
        <translation>Argumento %1: “%2” → “%3”</translation>
    </message>
    <message>
        <source>Line %1 %2</source>
        <translation>Línea %1 %2</translation>
    </message>
    <message>
        <source>Line %1 %2 of %3</source>
        <translation>Línea %1 %2 de %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 added</source>
        <translation>%1: %2 %3 añadido</translation>
    </message>
    <message>
        <source>%1: %2 %3 removed</source>
        <translation>%1: %2 %3 eliminado</translation>
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
        <translation>Línea %1 añadida: %2</translation>
    </message>
    <message>
        <source>Line %1 added: %2 (new point: %3)</source>
        <translation>Línea %1 añadida: %2 (punto nuevo: %3)</translation>
    </message>
    <message>
        <source>Line %1 removed: %2</source>
        <translation>Línea %1 eliminada: %2</translation>
    </message>
    <message>
        <source>Line %1 removed: %2 (with its point: %3)</source>
        <translation>Línea %1 eliminada: %2 (con su punto: %3)</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n línea movida de la línea %1 a la línea %2</numerusform>
            <numerusform>%n líneas movidas de la línea %1 a la línea %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 commented out: %2</source>
        <translation>Línea %1 pasada a comentario: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer commented out: %2</source>
        <translation>Línea %1 ya no es comentario: %2</translation>
    </message>
    <message>
        <source>Line %1 locked against editing: %2</source>
        <translation>Línea %1 bloqueada contra edición: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer locked against editing: %2</source>
        <translation>Línea %1 ya no bloqueada contra edición: %2</translation>
    </message>
    <message>
        <source>Line %1, comment: “%2” → “%3”</source>
        <translation>Línea %1, comentario: “%2” → “%3”</translation>
    </message>
    <message>
        <source>Line %1, comment added: “%2”</source>
        <translation>Línea %1, comentario añadido: “%2”</translation>
    </message>
    <message>
        <source>Line %1, comment removed: “%2”</source>
        <translation>Línea %1, comentario eliminado: “%2”</translation>
    </message>
    <message>
        <source>Line %1: %2 → %3</source>
        <translation>Línea %1: %2 → %3</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <comment>a position</comment>
        <translation>%1 añadido: %2</translation>
    </message>
    <message>
        <source>%1 removed: %2</source>
        <comment>a position</comment>
        <translation>%1 eliminado: %2</translation>
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
        <translation>Registros del diario perdidos: %n; no se pudo escribir ni el diario ni %1.</translation>
    </message>
    <message>
        <source>%n record(s) could not be written into the journal. Orders and notes are kept in %1.</source>
        <translation>Registros que no se pudieron escribir en el diario: %n. Las órdenes y las notas se conservan en %1.</translation>
    </message>
    <message>
        <source>What an earlier program left for the journal cannot be read: %1</source>
        <translation>No se puede leer lo que un programa anterior dejó para el diario: %1</translation>
    </message>
</context>
<context>
    <name>journal::Database</name>
    <message>
        <source>The folder of the journal cannot be made.</source>
        <translation>No se puede crear la carpeta del diario.</translation>
    </message>
    <message>
        <source>The journal was made by a newer version of Pendesk.</source>
        <translation>El diario fue creado por una versión más reciente de Pendesk.</translation>
    </message>
    <message>
        <source>The damaged journal cannot be given another name.</source>
        <translation>No se puede cambiar el nombre del diario dañado.</translation>
    </message>
</context>
<context>
    <name>journal::Store</name>
    <message>
        <source>The journal cannot be written: %1. Work goes on; records wait in memory.</source>
        <translation>No se puede escribir el diario: %1. El trabajo continúa; los registros esperan en memoria.</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>el disco no responde</translation>
    </message>
</context>
<context>
    <name>models::ActiveAlarmModel</name>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>Subcódigo</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Hora del controlador</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Visto por primera vez</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Veces</translation>
    </message>
    <message>
        <source>The controller tells the newest four alarms only, and this is not one of them. It may be active.</source>
        <translation>El controlador solo comunica las cuatro alarmas más recientes, y esta no es una de ellas. Puede estar activa.</translation>
    </message>
    <message>
        <source>First seen by this computer: %1</source>
        <translation>Vista por primera vez por este equipo: %1</translation>
    </message>
</context>
<context>
    <name>models::AlarmHistoryModel</name>
    <message>
        <source>Controller time</source>
        <translation>Hora del controlador</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>Subcódigo</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message>
        <source>Read here</source>
        <translation>Leído aquí</translation>
    </message>
</context>
<context>
    <name>models::CodeStatisticsModel</name>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Veces</translation>
    </message>
    <message>
        <source>Mean time between</source>
        <translation>Tiempo medio entre alarmas</translation>
    </message>
    <message>
        <source>Last, controller time</source>
        <translation>Última, hora del controlador</translation>
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
        <translation>menos de un minuto</translation>
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
        <translation>ALARMA</translation>
    </message>
    <message>
        <source>HELD</source>
        <translation>EN HOLD</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>HOLD: %1</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>EN MARCHA</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>PARADO</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>NO LINK</source>
        <translation>SIN ENLACE</translation>
    </message>
    <message>
        <source>CHECKING</source>
        <translation>COMPROBANDO</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>DESCONECTADO</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controlador</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motivo</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Ida y vuelta</translation>
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
        <translation>rechazado</translation>
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
        <translation>%1 se está ejecutando.</translation>
    </message>
    <message>
        <source>%1, favourite</source>
        <translation>%1, favorito</translation>
    </message>
</context>
<context>
    <name>models::OrderModel</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controlador</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Respuesta</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Persona</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Equipo</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
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
        <translation>en espera</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>en curso</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>done, read back identical</source>
        <translation>hecho, idéntico al volver a leer</translation>
    </message>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>hecho, el controlador cambió el formato de %n línea</numerusform>
            <numerusform>hecho, el controlador cambió el formato de %n líneas</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ read back different</source>
        <translation>▲ diferente al volver a leer</translation>
    </message>
    <message>
        <source>▲ sent, but it could not be read back</source>
        <translation>▲ enviado, pero no se pudo volver a leer</translation>
    </message>
    <message>
        <source>← to the computer</source>
        <translation>← al equipo</translation>
    </message>
    <message>
        <source>→ to the controller</source>
        <translation>→ al controlador</translation>
    </message>
    <message>
        <source>✕ delete</source>
        <translation>✕ borrar</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>Restante</translation>
    </message>
</context>
<context>
    <name>models::TrackModel</name>
    <message>
        <source>Not read at that time.</source>
        <translation>No leído en ese momento.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Min in view</source>
        <translation>Mín. en la vista</translation>
    </message>
    <message>
        <source>Max in view</source>
        <translation>Máx. en la vista</translation>
    </message>
</context>
<context>
    <name>models::VariableModel</name>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modificado</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>(vacío)</translation>
    </message>
    <message>
        <source>%1 (local)</source>
        <translation>%1 (local)</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>leído %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <comment>new value</comment>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>wrote %1, reads %2</source>
        <translation>escrito %1, leído %2</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <comment>old and new value</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>aún no enviado</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>no enviado: %1</translation>
    </message>
    <message>
        <source>being written…</source>
        <translation>escribiendo…</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>rechazado: %1</translation>
    </message>
    <message>
        <source>outcome unknown, look at the robot: %1</source>
        <translation>resultado desconocido, observe el robot: %1</translation>
    </message>
    <message>
        <source>accepted, but another value was read back</source>
        <translation>aceptado, pero al volver a leer se obtuvo otro valor</translation>
    </message>
    <message>
        <source>The controller calls it “%1”.</source>
        <translation>El controlador la llama “%1”.</translation>
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
        <source>refused</source>
        <translation>rechazado</translation>
    </message>
</context>
<context>
    <name>models::WatchModel</name>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>In jobs</source>
        <translation>En trabajos</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Rising edges</source>
        <translation>Flancos de subida</translation>
    </message>
    <message>
        <source>Falling edges</source>
        <translation>Flancos de bajada</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modificado</translation>
    </message>
</context>
<context>
    <name>motion::JogStep</name>
    <message>
        <source>A step must be above 0 and at most %1 pulses.</source>
        <translation>Un paso debe ser mayor que 0 y como máximo de %1 pulsos.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1 mm.</source>
        <translation>Un paso debe ser mayor que 0 y como máximo de %1 mm.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1°.</source>
        <translation>Un paso debe ser mayor que 0 y como máximo de %1°.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>La posición actual no se leyó.</translation>
    </message>
    <message>
        <source>The group has no such axis.</source>
        <translation>El grupo no tiene ese eje.</translation>
    </message>
</context>
<context>
    <name>motion::Plan</name>
    <message>
        <source>The speed must be above 0 and at most %1 mm/s.</source>
        <translation>La velocidad debe ser mayor que 0 y como máximo de %1 mm/s.</translation>
    </message>
    <message>
        <source>The rotation speed must be above 0 and at most %1 °/s.</source>
        <translation>La velocidad de rotación debe ser mayor que 0 y como máximo de %1 °/s.</translation>
    </message>
    <message>
        <source>The joint speed must be above 0 and at most %1 %.</source>
        <translation>La velocidad articular debe ser mayor que 0 y como máximo del %1 %.</translation>
    </message>
    <message>
        <source>Where this frame stands cannot be read over HSES, so nobody here knows how far the move would go: use the base frame or an increment.</source>
        <translation>La ubicación de este sistema de coordenadas no se puede leer por HSES, así que aquí no se sabe hasta dónde llegaría el movimiento: utilice el sistema de coordenadas base o un incremento.</translation>
    </message>
    <message>
        <source>This robot stands on base axes, and HSES does not tell where they are in mm: enter where they shall be.</source>
        <translation>Este robot está montado sobre ejes base, y HSES no indica su posición en mm: introduzca dónde deben estar.</translation>
    </message>
    <message>
        <source>The position has no six axes.</source>
        <translation>La posición no tiene seis ejes.</translation>
    </message>
    <message>
        <source>The tool point stands outside the box of this controller.</source>
        <translation>El punto de herramienta está fuera de la caja límite de este controlador.</translation>
    </message>
    <message>
        <source>The move would leave the box of this controller.</source>
        <translation>El movimiento saldría de la caja límite de este controlador.</translation>
    </message>
    <message>
        <source>User and tool frames are off until the profile says that they were checked on the robot.</source>
        <translation>Los sistemas de coordenadas de usuario y de herramienta están bloqueados hasta que el perfil indique que se comprobaron en el robot.</translation>
    </message>
    <message>
        <source>The user frame must be from 1 to 63.</source>
        <translation>El sistema de coordenadas de usuario debe ser de 1 a 63.</translation>
    </message>
    <message>
        <source>The tool must be from 0 to 63.</source>
        <translation>La herramienta debe ser de 0 a 63.</translation>
    </message>
    <message>
        <source>A base or a station is moved in pulses.</source>
        <translation>Una base o una estación se mueve en pulsos.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>La posición actual no se leyó.</translation>
    </message>
    <message>
        <source>A target in pulses can only be reached by a joint move: how far the tool point would go, and so how fast, is not known here.</source>
        <translation>Un destino en pulsos solo se puede alcanzar con un movimiento articular: aquí no se sabe cuánto se desplazaría el punto de herramienta ni, por tanto, a qué velocidad.</translation>
    </message>
    <message>
        <source>This controller has a box, and where pulses lead is not known here: use the base frame.</source>
        <translation>Este controlador tiene una caja límite, y aquí no se sabe adónde llevan los pulsos: utilice el sistema de coordenadas base.</translation>
    </message>
</context>
<context>
    <name>names::Sentences</name>
    <message>
        <source>%1 has no signal #%2.</source>
        <translation>%1 no tiene ninguna señal #%2.</translation>
    </message>
    <message>
        <source>There is no #%1: the last digit of a signal is 0 to 7.</source>
        <translation>No existe #%1: la última cifra de una señal va de 0 a 7.</translation>
    </message>
    <message>
        <source>There is no %1#(%2): this controller has %1#(1) to %1#(%3).</source>
        <translation>No existe %1#(%2): este controlador tiene de %1#(1) a %1#(%3).</translation>
    </message>
    <message>
        <source>“%1” is not a signal. Write #00010, IN#(1) or OT#(1).</source>
        <translation>“%1” no es una señal. Escriba #00010, IN#(1) u OT#(1).</translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message>
        <source>Active alarms</source>
        <translation>Alarmas activas</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Reconocer</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Reconocer todas</translation>
    </message>
    <message>
        <source>Acknowledging is noted on this computer only. The robot does not hear of it.</source>
        <translation>El reconocimiento solo se anota en este equipo. El robot no se entera de ello.</translation>
    </message>
    <message>
        <source>Choose one or more alarms in the table first.</source>
        <translation>Seleccione primero una o varias alarmas en la tabla.</translation>
    </message>
    <message>
        <source>Whether there is an alarm is not known now.</source>
        <translation>Ahora no se sabe si hay una alarma.</translation>
    </message>
    <message>
        <source>There is no alarm to clear.</source>
        <translation>No hay ninguna alarma que restablecer.</translation>
    </message>
    <message>
        <source>Clears the alarms whose causes are gone.</source>
        <translation>Restablece las alarmas cuya causa ha desaparecido.</translation>
    </message>
    <message>
        <source>Clears, if the cause is gone: %1.</source>
        <translation>Restablece, si la causa ha desaparecido: %1.</translation>
    </message>
    <message>
        <source>Whether there is an error is not known now.</source>
        <translation>Ahora no se sabe si hay un error.</translation>
    </message>
    <message>
        <source>Clears the error message at the pendant, and no alarm.</source>
        <translation>Borra el mensaje de error en la consola de programación, pero ninguna alarma.</translation>
    </message>
    <message>
        <source>There is no error to clear.</source>
        <translation>No hay ningún error que borrar.</translation>
    </message>
    <message>
        <source>Not connected: nothing is known of the active alarms.</source>
        <translation>No conectado: no se sabe nada de las alarmas activas.</translation>
    </message>
    <message>
        <source>The alarms have not been read yet.</source>
        <translation>Las alarmas aún no se han leído.</translation>
    </message>
    <message>
        <source>The controller does not tell its alarms.</source>
        <translation>El controlador no comunica sus alarmas.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>%n alarma activa en la última lectura.</numerusform>
            <numerusform>%n alarmas activas en la última lectura.</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>No hay ninguna alarma activa.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>%n alarma activa, la más reciente primero.</numerusform>
            <numerusform>%n alarmas activas, la más reciente primero.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset accepted. Reading the alarms…</source>
        <translation>Restablecimiento aceptado. Leyendo las alarmas…</translation>
    </message>
    <message>
        <source>Reset accepted. Whether an alarm is left is not known: the status cannot be read.</source>
        <translation>Restablecimiento aceptado. No se sabe si queda alguna alarma: no se puede leer el estado.</translation>
    </message>
    <message>
        <source>Reset accepted. No alarm is active any more.</source>
        <translation>Restablecimiento aceptado. Ya no hay ninguna alarma activa.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first.</source>
        <translation>▲ Aceptado, sigue activa: elimine primero la causa.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first. Left are: %1.</source>
        <translation>▲ Aceptado, sigue activa: elimine primero la causa. Quedan: %1.</translation>
    </message>
    <message>
        <source>Cancel error accepted.</source>
        <translation>Cancelación del error aceptada.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Past alarms</source>
        <translation>Alarmas anteriores</translation>
    </message>
    <message>
        <source>Most frequent</source>
        <translation>Más frecuentes</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notas</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>All lists</source>
        <translation>Todas las listas</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search code, text or time</source>
        <translation>Buscar código, texto u hora</translation>
    </message>
    <message>
        <source>Most frequent alarms</source>
        <translation>Alarmas más frecuentes</translation>
    </message>
    <message>
        <source>Counted in everything this journal has of the controller. The times between are by the controller&apos;s clock; steps of that clock are left out.</source>
        <translation>Se cuenta todo lo que este diario contiene del controlador. Los tiempos entre alarmas se rigen por el reloj del controlador; los saltos de ese reloj se omiten.</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>Nota sobre %1</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Detener la lectura</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>Leer ahora</translation>
    </message>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>Leyendo el historial del controlador: %n entrada leída.</numerusform>
            <numerusform>Leyendo el historial del controlador: %n entradas leídas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>No se puede leer el diario: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>La lectura se detuvo. %n entrada en el diario.</numerusform>
            <numerusform>La lectura se detuvo. %n entradas en el diario.</numerusform>
        </translation>
    </message>
    <message>
        <source>The history could not be read to its end: %1.</source>
        <translation>No se pudo leer el historial hasta el final: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>La entrada más reciente (%n) del diario; la exportación las contiene todas.</numerusform>
            <numerusform>Las %n entradas más recientes del diario; la exportación las contiene todas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>%n entrada en el diario, conservada de forma permanente.</numerusform>
            <numerusform>%n entradas en el diario, conservadas de forma permanente.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export past alarms</source>
        <translation>Exportar alarmas anteriores</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>%n entrada exportada.</numerusform>
            <numerusform>%n entradas exportadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>No exportado: %1.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message>
        <source>Save note</source>
        <translation>Guardar nota</translation>
    </message>
    <message>
        <source>Export notes…</source>
        <translation>Exportar notas…</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>%n nota exportada.</numerusform>
            <numerusform>%n notas exportadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>No exportado: %1.</translation>
    </message>
    <message>
        <source>Export notes</source>
        <translation>Exportar notas</translation>
    </message>
    <message>
        <source>Codes with a note</source>
        <translation>Códigos con nota</translation>
    </message>
    <message>
        <source>Alarm code</source>
        <translation>Código de alarma</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>What we did</source>
        <translation>Qué hicimos</translation>
    </message>
    <message>
        <source>The notes cannot be read: %1.</source>
        <translation>No se pueden leer las notas: %1.</translation>
    </message>
    <message>
        <source>No note yet.</source>
        <translation>Aún no hay ninguna nota.</translation>
    </message>
    <message>
        <source>Last changed by %1, %2.</source>
        <translation>Último cambio por %1, %2.</translation>
    </message>
</context>
<context>
    <name>pages::AxesCard</name>
    <message>
        <source>pulses</source>
        <translation>pulsos</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>following error, pulses</source>
        <translation>error de seguimiento, pulsos</translation>
    </message>
    <message>
        <source>torque, raw</source>
        <translation>par, sin procesar</translation>
    </message>
    <message>
        <source>As the controller sends it: the unit is stated nowhere.</source>
        <translation>Tal como lo envía el controlador: la unidad no se indica en ningún sitio.</translation>
    </message>
    <message>
        <source>encoder, °C</source>
        <translation>encoder, °C</translation>
    </message>
    <message>
        <source>min</source>
        <translation>mín.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C</source>
        <translation>Convertidor %1: %2 °C</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C, last seen %3</source>
        <translation>Convertidor %1: %2 °C, visto por última vez: %3</translation>
    </message>
    <message>
        <source>Converter temperature: %1</source>
        <translation>Temperatura del convertidor: %1</translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message>
        <source>Backups</source>
        <translation>Copias de seguridad</translation>
    </message>
    <message>
        <source> newest</source>
        <translation> más recientes</translation>
    </message>
    <message>
        <source>Keep any number</source>
        <translation>Conservar cualquier número</translation>
    </message>
    <message>
        <source> days</source>
        <translation> días</translation>
    </message>
    <message>
        <source>Keep any age</source>
        <translation>Conservar cualquier antigüedad</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Hacer copia ahora</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>Correcto: cada byte de %n archivo está tal como se escribió.</numerusform>
            <numerusform>Correcto: cada byte de %n archivos está tal como se escribió.</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ Not good: %1</source>
        <translation>▲ Incorrecto: %1</translation>
    </message>
    <message>
        <source>After a backup keep</source>
        <translation>Tras una copia de seguridad conservar</translation>
    </message>
    <message>
        <source>The last good backup and pinned ones are never deleted.</source>
        <translation>La última copia de seguridad correcta y las fijadas no se borran nunca.</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparar con</translation>
    </message>
    <message>
        <source>with the backup before</source>
        <translation>con la copia de seguridad anterior</translation>
    </message>
    <message>
        <source>with the newest backup</source>
        <translation>con la copia de seguridad más reciente</translation>
    </message>
    <message>
        <source>with the controller now</source>
        <translation>con el controlador ahora</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>Restaurar…</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>En %1</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Soltar</translation>
    </message>
    <message>
        <source>Choose a backup first.</source>
        <translation>Seleccione primero una copia de seguridad.</translation>
    </message>
    <message>
        <source>Files are being read.</source>
        <translation>Se están leyendo archivos.</translation>
    </message>
    <message>
        <source>Reading file %1 of %2…</source>
        <translation>Leyendo el archivo %1 de %2…</translation>
    </message>
    <message>
        <source>Reading the lists…</source>
        <translation>Leyendo las listas…</translation>
    </message>
    <message>
        <source>▲ There is no new backup: %1</source>
        <translation>▲ No hay ninguna copia de seguridad nueva: %1</translation>
    </message>
    <message>
        <source>▲ %1 of %2 files were backed up.</source>
        <translation>▲ Se hizo copia de seguridad de %1 de %2 archivos.</translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>Se hizo copia de seguridad de %n archivo, el único.</numerusform>
            <numerusform>Se hizo copia de seguridad de todos los %n archivos.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading every byte…</source>
        <translation>Leyendo cada byte…</translation>
    </message>
    <message>
        <source>There is no other backup to compare with.</source>
        <translation>No hay otra copia de seguridad con la que comparar.</translation>
    </message>
    <message>
        <source>The controller&apos;s files were read.</source>
        <translation>Se leyeron los archivos del controlador.</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>Carpeta de las copias de seguridad</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Exported.</source>
        <translation>Exportada.</translation>
    </message>
    <message>
        <source>▲ Not exported: %1</source>
        <translation>▲ No exportada: %1</translation>
    </message>
    <message>
        <source>Export the backup</source>
        <translation>Exportar la copia de seguridad</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Archivos zip (*.zip)</translation>
    </message>
    <message>
        <source>Exporting to %1…</source>
        <translation>Exportando a %1…</translation>
    </message>
    <message>
        <source>the controller now</source>
        <translation>el controlador ahora</translation>
    </message>
</context>
<context>
    <name>pages::CartesianCard</name>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>min</source>
        <translation>mín.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>máx.</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>Punto de herramienta</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>Forma ampliada</translation>
    </message>
    <message>
        <source>%1 · base frame, tool %2</source>
        <translation>%1 · sistema de coordenadas base, herramienta %2</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · sistema de coordenadas base</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 no tiene punto de herramienta: HSES solo lo indica para robots.</translation>
    </message>
    <message>
        <source>%1, base frame, tool %2</source>
        <translation>%1, sistema de coordenadas base, herramienta %2</translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message>
        <source>≠ changed</source>
        <translation>≠ modificado</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ nuevo</translation>
    </message>
    <message>
        <source>− gone</source>
        <translation>− eliminado</translation>
    </message>
    <message>
        <source>▲ not read, nobody knows</source>
        <translation>▲ no leído, no se sabe</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>Archivos diferentes</translation>
    </message>
    <message>
        <source>Choose a backup and compare it.</source>
        <translation>Seleccione una copia de seguridad y compárela.</translation>
    </message>
    <message>
        <source>Not counted as a difference:</source>
        <translation>No se cuenta como diferencia:</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>%n archivo diferente</numerusform>
            <numerusform>%n archivos diferentes</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a file above.</source>
        <translation>Seleccione arriba un archivo.</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>No hay diferencias.</translation>
    </message>
    <message>
        <source>This file is not in the backup as it was written.</source>
        <translation>Este archivo no está en la copia de seguridad tal como se escribió.</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>no se cuenta</translation>
    </message>
    <message>
        <source>Comparison: from %1 to %2</source>
        <translation>Comparación: de %1 a %2</translation>
    </message>
    <message>
        <source>The files are being compared…</source>
        <translation>Se están comparando los archivos…</translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>No se cuenta: %n contador, registro o similar</numerusform>
            <numerusform>No se cuentan: %n contadores, registros y similares</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::CycleCard</name>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>Real</translation>
    </message>
    <message>
        <source>Requested here</source>
        <translation>Solicitado aquí</translation>
    </message>
    <message>
        <source>Nothing was requested from here.</source>
        <translation>Desde aquí no se solicitó nada.</translation>
    </message>
    <message>
        <source>Cycle mode to request</source>
        <translation>Modo de ciclo que se solicita</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Solicitar</translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n archivo</numerusform>
            <numerusform>%n archivos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilesPage</name>
    <message>
        <source>This computer</source>
        <translation>Este equipo</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controlador</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Leer de nuevo</translation>
    </message>
    <message>
        <source>← Fetch</source>
        <translation>← Obtener</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Editar…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Folder of the files</source>
        <translation>Carpeta de los archivos</translation>
    </message>
    <message>
        <source>Type of the files</source>
        <translation>Tipo de los archivos</translation>
    </message>
    <message>
        <source>Send →</source>
        <translation>Enviar →</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Borrar…</translation>
    </message>
    <message>
        <source>There are no controller files in this folder.</source>
        <translation>No hay archivos de controlador en esta carpeta.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>Leyendo la lista…</translation>
    </message>
    <message>
        <source>The controller lists no files of this type.</source>
        <translation>El controlador no muestra archivos de este tipo.</translation>
    </message>
    <message>
        <source>Choose files on the left first.</source>
        <translation>Seleccione primero archivos a la izquierda.</translation>
    </message>
    <message>
        <source>Choose files on the right first.</source>
        <translation>Seleccione primero archivos a la derecha.</translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Size of the tiles</source>
        <translation>Tamaño de las fichas</translation>
    </message>
    <message>
        <source>HOLD ALL</source>
        <translation>HOLD A TODOS</translation>
    </message>
    <message>
        <source>HOLD all controllers (software)</source>
        <translation>HOLD a todos los controladores (software)</translation>
    </message>
    <message>
        <source>every station that is not off</source>
        <translation>toda estación no desconectada</translation>
    </message>
    <message>
        <source>Connect all</source>
        <translation>Conectar todos</translation>
    </message>
    <message>
        <source>Back up all</source>
        <translation>Copia de todos</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabla</translation>
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
        <translation>Controladores</translation>
    </message>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>%n controlador</numerusform>
            <numerusform>%n controladores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n conectado</numerusform>
            <numerusform>%n conectados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>%n sin enlace</numerusform>
            <numerusform>%n sin enlace</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>%n estación no desconectada</numerusform>
            <numerusform>%n estaciones no desconectadas</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ HOLD was not confirmed by %1: look at the robot.</source>
        <translation>▲ HOLD no fue confirmado por %1: observe el robot.</translation>
    </message>
    <message>
        <source>HOLD is being asked of %1.</source>
        <translation>Se está solicitando HOLD a %1.</translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>HOLD fue confirmado por %n controlador.</numerusform>
            <numerusform>HOLD fue confirmado por %n controladores.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::GroupCard</name>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
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
        <translation>En HOLD por</translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message>
        <source>User in</source>
        <translation>Ent. usuario</translation>
    </message>
    <message>
        <source>User out</source>
        <translation>Sal. usuario</translation>
    </message>
    <message>
        <source>External in</source>
        <translation>Ent. externa</translation>
    </message>
    <message>
        <source>Network in</source>
        <translation>Ent. red</translation>
    </message>
    <message>
        <source>External out</source>
        <translation>Sal. externa</translation>
    </message>
    <message>
        <source>Network out</source>
        <translation>Sal. red</translation>
    </message>
    <message>
        <source>System in</source>
        <translation>Ent. sistema</translation>
    </message>
    <message>
        <source>System out</source>
        <translation>Sal. sistema</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>Relés</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Control</translation>
    </message>
    <message>
        <source>Pseudo in</source>
        <translation>Pseudoent.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Area of signals</source>
        <translation>Área de señales</translation>
    </message>
    <message>
        <source>Watched signals</source>
        <translation>Señales vigiladas</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>Contar desde 0</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Vigilar</translation>
    </message>
    <message>
        <source>Over HSES only network inputs can be written: this lamp only shows.</source>
        <translation>Por HSES solo se pueden escribir entradas de red: este piloto solo indica.</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Escribir…</translation>
    </message>
    <message>
        <source>Name it here…</source>
        <translation>Dar nombre aquí…</translation>
    </message>
    <message>
        <source>Take the local name away</source>
        <translation>Quitar el nombre local</translation>
    </message>
    <message>
        <source>Watch no longer</source>
        <translation>Dejar de vigilar</translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation>Copiar la dirección</translation>
    </message>
    <message>
        <source>Edges are counted from what is read four times a second; shorter pulses are not seen.</source>
        <translation>Los flancos se cuentan a partir de lo que se lee cuatro veces por segundo; los impulsos más cortos no se ven.</translation>
    </message>
    <message>
        <source>Network inputs can be written: press Enter on a lamp.</source>
        <translation>Las entradas de red se pueden escribir: pulse Intro sobre un piloto.</translation>
    </message>
    <message>
        <source>These lamps only show: over HSES only network inputs can be written.</source>
        <translation>Estos pilotos solo indican: por HSES solo se pueden escribir entradas de red.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>%n grupo a partir de %1 rechazado: %2.</numerusform>
            <numerusform>%n grupos a partir de %1 rechazados: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The controller&apos;s names are not known: %1.</source>
        <translation>No se conocen los nombres del controlador: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>%n línea de IONAME.DAT no se pudo leer.</numerusform>
            <numerusform>%n líneas de IONAME.DAT no se pudieron leer.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JobCard</name>
    <message>
        <source>master task</source>
        <translation>tarea maestra</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Override de velocidad</translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message>
        <source>Jobs on the controller</source>
        <translation>Trabajos en el controlador</translation>
    </message>
    <message>
        <source>★ Favourite</source>
        <translation>★ Favorito</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Leer de nuevo</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Filter jobs by name</source>
        <translation>Filtrar trabajos por nombre</translation>
    </message>
    <message>
        <source>The list could not be read: %1.</source>
        <translation>No se pudo leer la lista: %1.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>Leyendo la lista…</translation>
    </message>
    <message>
        <source>The list was not read yet.</source>
        <translation>La lista aún no se ha leído.</translation>
    </message>
    <message>
        <source>There is no job on the controller.</source>
        <translation>No hay ningún trabajo en el controlador.</translation>
    </message>
    <message>
        <source>No job has “%1” in its name.</source>
        <translation>Ningún trabajo tiene “%1” en su nombre.</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>leyendo…</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>%n trabajo</numerusform>
            <numerusform>%n trabajos</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, read at %2</source>
        <translation>%1, leído a las %2</translation>
    </message>
</context>
<context>
    <name>pages::JobTextCard</name>
    <message>
        <source>Job text</source>
        <translation>Texto del trabajo</translation>
    </message>
    <message>
        <source>Choose a job in the list to read it.</source>
        <translation>Seleccione un trabajo de la lista para leerlo.</translation>
    </message>
    <message>
        <source>Follow what is executed</source>
        <translation>Seguir lo que se ejecuta</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Leer de nuevo</translation>
    </message>
    <message>
        <source>Labels and calls</source>
        <translation>Etiquetas y llamadas</translation>
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
        <translation>leyendo…</translation>
    </message>
    <message>
        <source>read at %1</source>
        <translation>leído a las %1</translation>
    </message>
    <message>
        <source>The job could not be read: %1.</source>
        <translation>No se pudo leer el trabajo: %1.</translation>
    </message>
    <message>
        <source>Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.</source>
        <translation>Leído a las %1. Desde entonces el controlador estuvo en TEACH o se perdió el enlace: esta copia puede ser antigua.</translation>
    </message>
    <message>
        <source>Reading the job…</source>
        <translation>Leyendo el trabajo…</translation>
    </message>
    <message>
        <source>The job was not read yet.</source>
        <translation>El trabajo aún no se ha leído.</translation>
    </message>
    <message>
        <source>This file holds no instructions that could be shown.</source>
        <translation>Este archivo no contiene instrucciones que se puedan mostrar.</translation>
    </message>
</context>
<context>
    <name>pages::JobsPage</name>
    <message>
        <source>Orders</source>
        <translation>Órdenes</translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message>
        <source>Jog</source>
        <translation>Movimiento manual</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Sistema de coordenadas</translation>
    </message>
    <message>
        <source>Keyboard too: hold Ctrl and Space on the button that has the focus</source>
        <translation>También con el teclado: mantenga pulsados Ctrl y Espacio en el botón que tiene el foco</translation>
    </message>
    <message>
        <source>Hold a button: one bounded step after another</source>
        <translation>Mantenga pulsado un botón: un paso limitado tras otro</translation>
    </message>
    <message>
        <source>After a lost link</source>
        <translation>Tras perderse el enlace</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>Último paso</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Axes (pulses)</source>
        <translation>Ejes (pulsos)</translation>
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
        <translation>como máximo un paso: %1 pulsos</translation>
    </message>
    <message>
        <source>at most one step: %1 mm or %2°, in %3 s at most</source>
        <translation>como máximo un paso: %1 mm o %2°, en %3 s como máximo</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>Desactivado: el perfil tiene un límite de movimiento que no es un número mayor que 0 (%1).</translation>
    </message>
    <message>
        <source>No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.</source>
        <translation>Sin respuesta al paso: se desconoce si se ejecutó. Se envió HOLD. Observe el robot.</translation>
    </message>
    <message>
        <source>Step sent…</source>
        <translation>Paso enviado…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>En movimiento…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%n paso, en reposo.</numerusform>
            <numerusform>%n pasos, en reposo.</numerusform>
        </translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Aún ninguno.</translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message>
        <source>At any time</source>
        <translation>En cualquier momento</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Hoy</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Últimos 7 días</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Últimos 30 días</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Diario</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controlador</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>Todos los controladores</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Todo</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Any outcome</source>
        <translation>Cualquier resultado</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search in all texts</source>
        <translation>Buscar en todos los textos</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>Leyendo el diario…</translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>No se puede leer el diario: %1.</translation>
    </message>
    <message>
        <source>Nothing was tried that fits this filter.</source>
        <translation>No se intentó nada que coincida con este filtro.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>El registro más reciente (%n). Desplácese hacia abajo para ver los anteriores.</numerusform>
            <numerusform>Los %n registros más recientes. Desplácese hacia abajo para ver los anteriores.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n registro</numerusform>
            <numerusform>%n registros</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a record to read all of it here.</source>
        <translation>Seleccione un registro para leerlo entero aquí.</translation>
    </message>
    <message>
        <source>%1: %2 at %3.</source>
        <translation>%1: %2 en %3.</translation>
    </message>
    <message>
        <source>Outcome: %1.</source>
        <translation>Resultado: %1.</translation>
    </message>
    <message>
        <source>By %1 at %2, level %3.</source>
        <translation>Por %1 en %2, nivel %3.</translation>
    </message>
    <message>
        <source>Export the journal</source>
        <translation>Exportar el diario</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>%n registro exportado.</numerusform>
            <numerusform>%n registros exportados.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>No exportado: %1.</translation>
    </message>
</context>
<context>
    <name>pages::LinkCard</name>
    <message>
        <source>%1 repeated</source>
        <translation>%1 repetidas</translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation>%1 sin respuesta</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>%1 tardías</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 duplicadas</translation>
    </message>
    <message>
        <source>%1 mismatched</source>
        <translation>%1 no coincidentes</translation>
    </message>
    <message>
        <source>%1 malformed</source>
        <translation>%1 mal formadas</translation>
    </message>
    <message>
        <source>%1 from elsewhere</source>
        <translation>%1 de otro origen</translation>
    </message>
    <message>
        <source>%1 busy</source>
        <translation>%1 ocupado</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Enlace</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>últimos 60 s</translation>
    </message>
    <message>
        <source>round trip p50 / p95</source>
        <translation>ida y vuelta p50 / p95</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdidas</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>solicitudes</translation>
    </message>
    <message>
        <source>last answer</source>
        <translation>última respuesta</translation>
    </message>
    <message>
        <source>sent / answered</source>
        <translation>enviadas / respondidas</translation>
    </message>
    <message>
        <source>unusual</source>
        <translation>anomalías</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 /s of %2</source>
        <translation>%1 /s de %2</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>hace %1</translation>
    </message>
</context>
<context>
    <name>pages::MotionPage</name>
    <message>
        <source>Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody may be inside the fence.</source>
        <translation>Movimiento remoto en modo automático. El interruptor de habilitación de la consola de programación no protege aquí a nadie. Nadie debe estar dentro del vallado.</translation>
    </message>
    <message>
        <source>Before each step</source>
        <translation>Antes de cada paso</translation>
    </message>
    <message>
        <source>Control group that moves</source>
        <translation>Grupo de control que se mueve</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>Grupo de control</translation>
    </message>
</context>
<context>
    <name>pages::MoveCard</name>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Type of the move</source>
        <translation>Tipo de movimiento</translation>
    </message>
    <message>
        <source>Frame of the target</source>
        <translation>Sistema de coordenadas del destino</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>Sistema de coordenadas de usuario</translation>
    </message>
    <message>
        <source>Base axes in mm</source>
        <translation>Ejes base en mm</translation>
    </message>
    <message>
        <source>Rehearse…</source>
        <translation>Comprobación previa…</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articular</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Straight, increment</source>
        <translation>Lineal, incremento</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>Sistema de coordenadas base</translation>
    </message>
    <message>
        <source>Robot frame</source>
        <translation>Sistema de coordenadas del robot</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>Sistema de coordenadas de herramienta</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Pulsos</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Sistema de coordenadas</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>target</source>
        <translation>destino</translation>
    </message>
    <message>
        <source>change</source>
        <translation>cambio</translation>
    </message>
    <message>
        <source>Speed in mm/s</source>
        <translation>Velocidad en mm/s</translation>
    </message>
    <message>
        <source>Rotation speed in °/s</source>
        <translation>Velocidad de rotación en °/s</translation>
    </message>
    <message>
        <source>Joint speed in %</source>
        <translation>Velocidad articular en %</translation>
    </message>
    <message>
        <source>mm/s, at most %1</source>
        <translation>mm/s, como máximo %1</translation>
    </message>
    <message>
        <source>°/s, at most %1</source>
        <translation>°/s, como máximo %1</translation>
    </message>
    <message>
        <source>% of joint speed, at most %1</source>
        <translation>% de la velocidad articular, como máximo %1</translation>
    </message>
    <message>
        <source>Target of %1 in %2</source>
        <translation>Destino de %1 en %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There are three base axes at most.</source>
        <translation>Hay tres ejes base como máximo.</translation>
    </message>
    <message>
        <source>Base axes: %1</source>
        <translation>Ejes base: %1</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>Desactivado: el perfil tiene un límite de movimiento que no es un número mayor que 0 (%1).</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <translation>Forma: %1</translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message>
        <source>Before sending</source>
        <translation>Antes de enviar</translation>
    </message>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>Enviar %n archivo</numerusform>
            <numerusform>Enviar %n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>on this computer</source>
        <translation>en este equipo</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>What would change in “%1”</source>
        <translation>Qué cambiaría en “%1”</translation>
    </message>
</context>
<context>
    <name>pages::OptionsCard</name>
    <message>
        <source>always: the button above, the Pause key or Ctrl+Shift+H.</source>
        <translation>siempre: el botón de arriba, la tecla Pausa o Ctrl+Mayús+H.</translation>
    </message>
    <message>
        <source>sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.</source>
        <translation>se envía repetidamente hasta que se confirme o hayan pasado 2 s. Tenga a mano la consola de programación.</translation>
    </message>
    <message>
        <source>there is no connection: use the pendant.</source>
        <translation>no hay conexión: utilice la consola de programación.</translation>
    </message>
    <message>
        <source>What can I do now?</source>
        <translation>¿Qué puedo hacer ahora?</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>possible</source>
        <translation>posible</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>no posible</translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message>
        <source>Pendant</source>
        <translation>Consola de programación</translation>
    </message>
    <message>
        <source>Message for the pendant</source>
        <translation>Mensaje para la consola de programación</translation>
    </message>
    <message>
        <source>Show on the pendant</source>
        <translation>Mostrar en la consola de programación</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 de %n byte</numerusform>
            <numerusform>%1 de %n bytes</numerusform>
        </translation>
    </message>
    <message>
        <source>Type a message first.</source>
        <translation>Escriba primero un mensaje.</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding cannot hold this: %1.</source>
        <translation>La codificación del controlador no puede representar esto: %1.</translation>
    </message>
    <message>
        <source>The message is too long for the pendant.</source>
        <translation>El mensaje es demasiado largo para la consola de programación.</translation>
    </message>
    <message>
        <source>HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.</source>
        <translation>HLOCK se activó desde aquí: la consola de programación está bloqueada, excepto su parada de emergencia.</translation>
    </message>
    <message>
        <source>HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not switched on.</source>
        <translation>HLOCK bloquea la consola de programación. Si está activado no se puede leer por HSES; desde aquí no se activó.</translation>
    </message>
</context>
<context>
    <name>pages::PointsBar</name>
    <message>
        <source>Take the present position</source>
        <translation>Tomar la posición actual</translation>
    </message>
    <message>
        <source>Take P</source>
        <translation>Tomar P</translation>
    </message>
    <message>
        <source>Earlier places</source>
        <translation>Posiciones anteriores</translation>
    </message>
    <message>
        <source>Keep the present position as P</source>
        <translation>Guardar la posición actual como P</translation>
    </message>
    <message>
        <source>P variable</source>
        <translation>Variable P</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>No se pudo leer %1: %2.</translation>
    </message>
    <message>
        <source>%1 is in another frame (%2): choose that frame and an absolute move to take it.</source>
        <translation>%1 está en otro sistema de coordenadas (%2): elija ese sistema y un movimiento absoluto para tomarla.</translation>
    </message>
    <message>
        <source>The target is %1.</source>
        <translation>El destino es %1.</translation>
    </message>
    <message>
        <source>Only the present position of a robot can be kept, once it was read.</source>
        <translation>Solo se puede guardar la posición actual de un robot, una vez leída.</translation>
    </message>
    <message>
        <source>%1 was written and read back.</source>
        <translation>%1 se escribió y se volvió a leer.</translation>
    </message>
    <message>
        <source>%1 was not verified: %2.</source>
        <translation>%1 no se verificó: %2.</translation>
    </message>
    <message>
        <source>%1 was written, but another value was read back.</source>
        <translation>%1 se escribió, pero al volver a leer se obtuvo otro valor.</translation>
    </message>
    <message>
        <source>No move has begun in this frame yet</source>
        <translation>Aún no ha comenzado ningún movimiento en este sistema de coordenadas</translation>
    </message>
    <message>
        <source>%1 is not taught.</source>
        <translation>%1 no está enseñado.</translation>
    </message>
    <message>
        <source>Other values are still being written.</source>
        <translation>Todavía se están escribiendo otros valores.</translation>
    </message>
    <message>
        <source>%1 holds this position already.</source>
        <translation>%1 ya contiene esta posición.</translation>
    </message>
</context>
<context>
    <name>pages::PositionCard</name>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>R1 · base frame, tool %1  ·  pulses</source>
        <translation>R1 · sistema de coordenadas base, herramienta %1  ·  pulsos</translation>
    </message>
    <message>
        <source>R1 · base frame  ·  pulses</source>
        <translation>R1 · sistema de coordenadas base  ·  pulsos</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message>
        <source>Control groups</source>
        <translation>Grupos de control</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>Restablecer mín. y máx.</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Copiar como texto</translation>
    </message>
    <message>
        <source>Not shown because refused: %1 of %2 control groups.</source>
        <translation>No se muestran por haber sido rechazados: %1 de %2 grupos de control.</translation>
    </message>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>%n grupo de control</numerusform>
            <numerusform>%n grupos de control</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::QueueCard</name>
    <message>
        <source>Transfers</source>
        <translation>Transferencias</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>Reintentar fallidas</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>Quitar terminadas</translation>
    </message>
</context>
<context>
    <name>pages::RegistersPage</name>
    <message>
        <source>How registers are written</source>
        <translation>Notación de los registros</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Decimal</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>Con signo</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>Hexadecimal</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binario</translation>
    </message>
    <message>
        <source>M000 to M559 can be written; the others belong to the ladder.</source>
        <translation>De M000 a M559 se pueden escribir; los demás pertenecen al programa de escalera (ladder).</translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message>
        <source>What changes in “%1” on %2</source>
        <translation>Qué cambia en “%1” en %2</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Enviar</translation>
    </message>
    <message>
        <source>Delete on %1</source>
        <translation>Borrar en %1</translation>
    </message>
    <message>
        <source>These files are deleted on %1:
%2
Before that each is copied to %3.</source>
        <translation>Estos archivos se borran en %1:
%2
Antes, cada uno se copia en %3.</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>Borrar %n archivo</numerusform>
            <numerusform>Borrar %n archivos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::SelectCard</name>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Select as</source>
        <translation>Seleccionar como</translation>
    </message>
    <message>
        <source>to be executed</source>
        <translation>trabajo que se ejecutará</translation>
    </message>
    <message>
        <source>master job</source>
        <translation>trabajo maestro</translation>
    </message>
    <message>
        <source>master job of sub task %1</source>
        <translation>trabajo maestro de la subtarea %1</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>Desde la línea</translation>
    </message>
    <message>
        <source>line </source>
        <translation>línea </translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>Seleccionar %1</translation>
    </message>
    <message>
        <source>Choose a job in the list first.</source>
        <translation>Seleccione primero un trabajo de la lista.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>tarea %1</translation>
    </message>
</context>
<context>
    <name>pages::SelectionCard</name>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Where it is</source>
        <translation>Dónde está</translation>
    </message>
    <message>
        <source>master task</source>
        <translation>tarea maestra</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcha</translation>
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
        <translation>Alimentación de servos</translation>
    </message>
    <message>
        <source>A job is running: servo off stops it at once.</source>
        <translation>Hay un trabajo en marcha: Servo OFF lo para de inmediato.</translation>
    </message>
    <message>
        <source>Servo on…</source>
        <translation>Servo ON…</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ON</translation>
    </message>
    <message>
        <source>Switch servo power on at %1?

The robot can move from then on. Nobody may be inside the fence.</source>
        <translation>¿Conectar la alimentación de servos en %1?

A partir de entonces el robot puede moverse. Nadie debe estar dentro del vallado.</translation>
    </message>
</context>
<context>
    <name>pages::StartCard</name>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>Iniciar…</translation>
    </message>
</context>
<context>
    <name>pages::StartPanel</name>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>No conectado</translation>
    </message>
    <message>
        <source>Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it.</source>
        <translation>No se lee ni se muestra nada. Al conectar solo se lee: con ello no se escribe, inicia ni mueve nada.</translation>
    </message>
    <message>
        <source>Connect to a controller…</source>
        <translation>Conectar con un controlador…</translation>
    </message>
    <message>
        <source>A controller in your network</source>
        <translation>Un controlador de su red</translation>
    </message>
    <message>
        <source>Enter its name or address. Pendesk checks step by step whether it answers, and says what is wrong where it does not.</source>
        <translation>Introduzca su nombre o dirección. Pendesk comprueba paso a paso si responde e indica qué está mal si no lo hace.</translation>
    </message>
    <message>
        <source>No robot at hand</source>
        <translation>Sin un robot a mano</translation>
    </message>
    <message>
        <source>The demo brings a simulated controller in this program. Everything can be tried with it, and no robot moves.</source>
        <translation>La demo trae un controlador simulado dentro de este programa. Con él se puede probar todo, y ningún robot se mueve.</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Abrir la demo</translation>
    </message>
    <message>
        <source>Recent controllers</source>
        <translation>Controladores recientes</translation>
    </message>
    <message>
        <source>Another controller…</source>
        <translation>Otro controlador…</translation>
    </message>
</context>
<context>
    <name>pages::StateCard</name>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcha</translation>
    </message>
    <message>
        <source>Hold · pendant</source>
        <translation>HOLD · consola</translation>
    </message>
    <message>
        <source>Hold · external</source>
        <translation>HOLD · externo</translation>
    </message>
    <message>
        <source>Hold · command</source>
        <translation>HOLD · comando</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Límite de velocidad</translation>
    </message>
</context>
<context>
    <name>pages::SystemCard</name>
    <message>
        <source>System</source>
        <translation>Sistema</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the system information</source>
        <translation>Copiar la información del sistema</translation>
    </message>
    <message>
        <source>The profile says %1, but this is the software of a %2: correct the profile.</source>
        <translation>El perfil indica %1, pero este es el software de un %2: corrija el perfil.</translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Show the sub tasks</source>
        <translation>Mostrar las subtareas</translation>
    </message>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>%n subtarea</numerusform>
            <numerusform>%n subtareas</numerusform>
        </translation>
    </message>
    <message>
        <source>Sub task %1</source>
        <translation>Subtarea %1</translation>
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
        <translation>ARMADO</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULACIÓN</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>NO CONECTADO</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>desde %1</translation>
    </message>
    <message>
        <source>last seen: %1</source>
        <translation>visto por última vez: %1</translation>
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
        <translation>▲ ya no es una copia de seguridad</translation>
    </message>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ falta %n archivo</numerusform>
            <numerusform>▲ faltan %n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>complete</source>
        <translation>completa</translation>
    </message>
    <message>
        <source>%1, pinned</source>
        <translation>%1, fijada</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Realizada</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Copias de seguridad</translation>
    </message>
    <message>
        <source>Changed</source>
        <comment>number of files</comment>
        <translation>Modificado</translation>
    </message>
</context>
<context>
    <name>pages::ToolPathCard</name>
    <message>
        <source>Tool path</source>
        <translation>Trayectoria de herramienta</translation>
    </message>
    <message>
        <source>Clear path</source>
        <translation>Borrar trayectoria</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · sistema de coordenadas base</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 no tiene punto de herramienta: HSES solo lo indica para robots.</translation>
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
        <translation>Añadir señal…</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exportar CSV…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Freezes the view; recording goes on.</source>
        <translation>Congela la vista; el registro continúa.</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Volver a en vivo</translation>
    </message>
    <message>
        <source>Time in view</source>
        <translation>Tiempo en la vista</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Tendencia</translation>
    </message>
    <message>
        <source>Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in its menu, or add a signal.</source>
        <translation>Aún no hay ninguna curva. Arrastre aquí un número desde cualquier página, elija “Añadir a la tendencia” en su menú o añada una señal.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Remove from trend</source>
        <translation>Quitar de la tendencia</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>Incidentes</translation>
    </message>
    <message>
        <source>60 s before an alarm, 20 s after</source>
        <translation>60 s antes de una alarma, 20 s después</translation>
    </message>
    <message>
        <source>Open incident</source>
        <translation>Abrir incidente</translation>
    </message>
    <message>
        <source>No alarm has been recorded yet.</source>
        <translation>Aún no se ha registrado ninguna alarma.</translation>
    </message>
    <message>
        <source>It could not be saved: %1</source>
        <translation>No se pudo guardar: %1</translation>
    </message>
    <message>
        <source>Incident of %1: %2</source>
        <translation>Incidente de %1: %2</translation>
    </message>
    <message>
        <source>Paused at %1; recording goes on</source>
        <translation>En pausa a las %1; el registro continúa</translation>
    </message>
    <message>
        <source>Nothing is recorded: no communication</source>
        <translation>No se registra nada: sin comunicación</translation>
    </message>
    <message>
        <source>Live; values of %1</source>
        <translation>En vivo; valores de las %1</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>%1 is refused by the controller.</source>
        <translation>El controlador rechaza %1.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>This incident cannot be read: %1</source>
        <translation>No se puede leer este incidente: %1</translation>
    </message>
    <message>
        <source>Export what is in view</source>
        <translation>Exportar lo que está en la vista</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>Archivos CSV (*.csv)</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>No se pudo escribir el archivo: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>Deshacer lo último</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Registros</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>%1 can only be read over HSES.</source>
        <translation>Por HSES, %1 solo se puede leer.</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Escribiendo…</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>Aplicar %n…</numerusform>
            <numerusform>Aplicar %n…</numerusform>
        </translation>
    </message>
    <message>
        <source>The values are being written.</source>
        <translation>Se están escribiendo los valores.</translation>
    </message>
    <message>
        <source>Nothing is staged: press Enter in a value.</source>
        <translation>No hay nada preparado: pulse Intro en un valor.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>No hay nada preparado.</translation>
    </message>
    <message>
        <source>Stages the values that stood there before.</source>
        <translation>Prepara los valores que había antes.</translation>
    </message>
    <message>
        <source>Nothing was written that could be undone.</source>
        <translation>No se escribió nada que se pueda deshacer.</translation>
    </message>
    <message>
        <source>Import values</source>
        <translation>Importar valores</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>Archivos CSV (*.csv)</translation>
    </message>
    <message>
        <source>Export values</source>
        <translation>Exportar valores</translation>
    </message>
    <message>
        <source>%1 stays as it is: %2</source>
        <comment>variable: reason</comment>
        <translation>%1 queda como está: %2</translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message>
        <source>%1 was written.</source>
        <translation>%1 se escribió.</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>Leyendo %n variable…</numerusform>
            <numerusform>Leyendo %n variables…</numerusform>
        </translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>No se puede leer el archivo: %1</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>No se pudo escribir el archivo: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariablesPage</name>
    <message>
        <source>Verify…</source>
        <translation>Verificar…</translation>
    </message>
    <message>
        <source>Kind of variable</source>
        <translation>Clase de variable</translation>
    </message>
    <message>
        <source>Compares two variables with the pendant. It only reads.</source>
        <translation>Compara dos variables con la consola de programación. Solo lee.</translation>
    </message>
    <message>
        <source>New watch page…</source>
        <translation>Página de vigilancia nueva…</translation>
    </message>
    <message>
        <source>New watch page</source>
        <translation>Página de vigilancia nueva</translation>
    </message>
    <message>
        <source>Name of the page</source>
        <translation>Nombre de la página</translation>
    </message>
    <message>
        <source>Watch: %1</source>
        <translation>Vigilancia: %1</translation>
    </message>
    <message>
        <source>Delete this watch page</source>
        <translation>Borrar esta página de vigilancia</translation>
    </message>
    <message>
        <source>Show on the watch page “%1”</source>
        <translation>Mostrar en la página de vigilancia “%1”</translation>
    </message>
    <message>
        <source>Take off this watch page</source>
        <translation>Quitar de esta página de vigilancia</translation>
    </message>
    <message>
        <source>There is no watch page yet.</source>
        <translation>Aún no hay ninguna página de vigilancia.</translation>
    </message>
    <message>
        <source>Numbering not verified: nothing is written before it was compared with the pendant.</source>
        <translation>Numeración no verificada: no se escribe nada antes de compararla con la consola de programación.</translation>
    </message>
    <message>
        <source>Simulation: number %1 on the network is B000.</source>
        <translation>Simulación: el número %1 en la red es B000.</translation>
    </message>
    <message>
        <source>Numbering verified %1: number %2 on the network is B000.</source>
        <translation>Numeración verificada %1: el número %2 en la red es B000.</translation>
    </message>
</context>
<context>
    <name>pages::start::RecentTile</name>
    <message>
        <source>no connection noted yet</source>
        <translation>aún sin conexión registrada</translation>
    </message>
    <message>
        <source>connected today %1</source>
        <comment>the time</comment>
        <translation>conectado hoy a las %1</translation>
    </message>
    <message>
        <source>connected yesterday %1</source>
        <comment>the time</comment>
        <translation>conectado ayer a las %1</translation>
    </message>
    <message>
        <source>connected %1 %2</source>
        <comment>the date, the time</comment>
        <translation>conectado el %1 a las %2</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>Conectar con %1</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>simulación</translation>
    </message>
</context>
<context>
    <name>pages::start::SetupCard</name>
    <message>
        <source>What must be set on the pendant</source>
        <translation>Qué se debe ajustar en la consola de programación</translation>
    </message>
    <message>
        <source>Menus differ by model and software</source>
        <translation>Los menús varían según el modelo y el software</translation>
    </message>
    <message>
        <source>To be found</source>
        <translation>Para poder encontrarlo</translation>
    </message>
    <message>
        <source>The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has an IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.</source>
        <translation>La función de servidor Ethernet (HSES) está activada; es una opción en DX100, DX200 y FS100. El controlador tiene una dirección IPv4 en la red de este equipo, y ningún cortafuegos entre ambos descarta UDP %1 y %2.</translation>
    </message>
    <message>
        <source>To take orders</source>
        <translation>Para que acepte órdenes</translation>
    </message>
    <message>
        <source>Only for starting, moving, resetting and files, not for reading: %1.</source>
        <translation>Solo para iniciar, mover, restablecer y para archivos, no para leer: %1.</translation>
    </message>
    <message>
        <source>To select and replace</source>
        <translation>Para seleccionar y reemplazar</translation>
    </message>
    <message>
        <source>For selecting jobs from here: %1. For replacing files that exist there: %2.</source>
        <translation>Para seleccionar trabajos desde aquí: %1. Para reemplazar archivos que ya existen allí: %2.</translation>
    </message>
</context>
<context>
    <name>pendesk</name>
    <message>
        <source>A teach and monitor desk for Yaskawa robot controllers.</source>
        <translation>Un puesto para enseñar y supervisar controladores de robot Yaskawa.</translation>
    </message>
    <message>
        <source>Connect to a simulated controller inside the program.</source>
        <translation>Conectar con un controlador simulado dentro del programa.</translation>
    </message>
    <message>
        <source>light, dark, or auto for the desktop&apos;s choice.</source>
        <translation>light, dark o auto para la elección del escritorio.</translation>
    </message>
    <message>
        <source>Language of the window, as a code such as de; the desktop&apos;s unless told otherwise.</source>
        <translation>Idioma de la ventana, como código, por ejemplo de; si no se indica, el del escritorio.</translation>
    </message>
    <message>
        <source>Allow watching, HOLD and servo off alone, whatever the person at the desk tries.</source>
        <translation>Permitir únicamente observar, HOLD y Servo OFF, intente lo que intente la persona en el puesto.</translation>
    </message>
    <message>
        <source>Write pictures of every page to this folder, print the status read, and end.</source>
        <translation>Escribir imágenes de todas las páginas en esta carpeta, mostrar el estado leído y terminar.</translation>
    </message>
    <message>
        <source>Print when the window was painted and when the first status was live.</source>
        <translation>Mostrar cuándo se dibujó la ventana y cuándo el primer estado estuvo en vivo.</translation>
    </message>
    <message>
        <source>--demo brings its own controller: leave out --host and --profile.</source>
        <translation>--demo trae su propio controlador: omita --host y --profile.</translation>
    </message>
    <message>
        <source>--theme must be light, dark or auto.</source>
        <translation>--theme debe ser light, dark o auto.</translation>
    </message>
    <message>
        <source>--language must be one of: %1.</source>
        <translation>--language debe ser uno de estos: %1.</translation>
    </message>
    <message>
        <source>“%1” is not an option.</source>
        <translation>“%1” no es una opción.</translation>
    </message>
    <message>
        <source>--pictures needs a folder, and --demo, --host or --profile.</source>
        <translation>--pictures necesita una carpeta y --demo, --host o --profile.</translation>
    </message>
    <message>
        <source>Write one picture of all pages, light and dark, in English, German and Japanese, and end.</source>
        <translation>Escribir una sola imagen de todas las páginas, en claro y oscuro, en inglés, alemán y japonés, y terminar.</translation>
    </message>
    <message>
        <source>--contact-sheet needs a file, and --demo, --host or --profile.</source>
        <translation>--contact-sheet necesita un archivo y --demo, --host o --profile.</translation>
    </message>
</context>
<context>
    <name>pendesk::Pictures</name>
    <message>
        <source>not everything was read</source>
        <translation>no se leyó todo</translation>
    </message>
    <message>
        <source>pendesk: %1 cannot be written.</source>
        <translation>pendesk: no se puede escribir %1.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcha</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Executing</source>
        <translation>En ejecución</translation>
    </message>
    <message>
        <source>Pictures are in %1</source>
        <translation>Las imágenes están en %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>no se puede crear la carpeta %1</translation>
    </message>
    <message>
        <source>no live controller within 5 s: %1</source>
        <translation>ningún controlador en vivo en 5 s: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>no se puede escribir %1</translation>
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
        <translation>Se detuvo en %1. Tal como estaba se encuentra en %2; “restore” desde ahí con este nombre lo repone.</translation>
    </message>
    <message>
        <source>Delete all but the newest N backups afterwards, never the last good one.</source>
        <translation>Borrar después todas las copias de seguridad salvo las N más recientes, nunca la última correcta.</translation>
    </message>
    <message>
        <source>Delete backups older than N days afterwards, never the last good one.</source>
        <translation>Borrar después las copias de seguridad de más de N días, nunca la última correcta.</translation>
    </message>
    <message>
        <source>Reads all files of the controller into DIR/&lt;controller&gt;/&lt;UTC time&gt;, in BagIt form.</source>
        <translation>Lee todos los archivos del controlador en DIR/&lt;controller&gt;/&lt;UTC time&gt;, en formato BagIt.</translation>
    </message>
    <message>
        <source>Reads a backup and tells whether it is what was written.</source>
        <translation>Lee una copia de seguridad e indica si está tal como se escribió.</translation>
    </message>
    <message>
        <source>Only print what would be done.</source>
        <translation>Mostrar solamente lo que se haría.</translation>
    </message>
    <message>
        <source>The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it.</source>
        <translation>La copia de seguridad no está tal como se escribió; “verify” indica qué está mal. No se ha hecho nada con ella.</translation>
    </message>
    <message>
        <source>“%1” is no file name.</source>
        <translation>“%1” no es un nombre de archivo.</translation>
    </message>
    <message>
        <source>Print for people instead of JSON.</source>
        <translation>Mostrar texto legible para personas en lugar de JSON.</translation>
    </message>
    <message>
        <source>The request that a reply answers.</source>
        <translation>La solicitud a la que contesta una respuesta.</translation>
    </message>
    <message>
        <source>The port of the packets: 10040 or 10041.</source>
        <translation>El puerto de los paquetes: 10040 o 10041.</translation>
    </message>
    <message>
        <source>A packet; without any, one a line on stdin.</source>
        <translation>Un paquete; si no se indica ninguno, uno por línea de stdin.</translation>
    </message>
    <message>
        <source>A job is running; files are not changed meanwhile.</source>
        <translation>Hay un trabajo en marcha; entretanto no se modifican archivos.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address.</source>
        <translation>El nombre “%1” no tiene dirección IPv4.</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>No se puede crear la carpeta “%1”.</translation>
    </message>
    <message>
        <source>%1 exists and is left alone; --yes replaces it.</source>
        <translation>%1 existe y no se toca; --yes lo reemplaza.</translation>
    </message>
    <message>
        <source>“%1” is no name that a controller takes.</source>
        <translation>“%1” no es un nombre que acepte un controlador.</translation>
    </message>
    <message>
        <source>%1 exists at the controller and is left alone; --replace replaces it.</source>
        <translation>%1 existe en el controlador y no se toca; --replace lo reemplaza.</translation>
    </message>
    <message>
        <source>Lists the jobs.</source>
        <translation>Muestra la lista de trabajos.</translation>
    </message>
    <message>
        <source>The folder for what comes; for rm, for the copies.</source>
        <translation>La carpeta para lo que llega; con rm, para las copias.</translation>
    </message>
    <message>
        <source>put: replace what the controller has.</source>
        <translation>put: reemplazar lo que tiene el controlador.</translation>
    </message>
    <message>
        <source>Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”.</source>
        <translation>Indique “ls”, “get NAME…”, “put FILE…” o “rm NAME…”.</translation>
    </message>
    <message>
        <source>read status, job, position and system information</source>
        <translation>leer el estado, el trabajo, la posición y la información del sistema</translation>
    </message>
    <message>
        <source>read model, system software and parameter version</source>
        <translation>leer el modelo, el software del sistema y la versión de parámetros</translation>
    </message>
    <message>
        <source>read the active alarms, or a list of the history</source>
        <translation>leer las alarmas activas, o una lista del historial</translation>
    </message>
    <message>
        <source>read where the robot stands</source>
        <translation>leer dónde está el robot</translation>
    </message>
    <message>
        <source>list the jobs</source>
        <translation>enumerar los trabajos</translation>
    </message>
    <message>
        <source>read I/O, write a network input</source>
        <translation>leer E/S, escribir una entrada de red</translation>
    </message>
    <message>
        <source>read and write registers</source>
        <translation>leer y escribir registros</translation>
    </message>
    <message>
        <source>read and write variables</source>
        <translation>leer y escribir variables</translation>
    </message>
    <message>
        <source>list, read, send and delete files</source>
        <translation>enumerar, leer, enviar y borrar archivos</translation>
    </message>
    <message>
        <source>read all files of a controller into a new backup</source>
        <translation>leer todos los archivos de un controlador en una copia de seguridad nueva</translation>
    </message>
    <message>
        <source>tell whether a backup is what was written</source>
        <translation>indicar si una copia de seguridad está tal como se escribió</translation>
    </message>
    <message>
        <source>compare two backups, or one with the controller</source>
        <translation>comparar dos copias de seguridad, o una con el controlador</translation>
    </message>
    <message>
        <source>send back what differs from a backup</source>
        <translation>devolver al controlador lo que difiere de una copia de seguridad</translation>
    </message>
    <message>
        <source>read values again and again</source>
        <translation>leer valores una y otra vez</translation>
    </message>
    <message>
        <source>take packets given in hex apart</source>
        <translation>descomponer paquetes dados en hexadecimal</translation>
    </message>
    <message>
        <source>Usage: pendeskctl VERB [options]</source>
        <translation>Uso: pendeskctl VERB [opciones]</translation>
    </message>
    <message>
        <source>pendeskctl VERB --help tells more.</source>
        <translation>pendeskctl VERB --help da más información.</translation>
    </message>
    <message>
        <source>there is no verb “%1”.</source>
        <translation>no existe el verbo “%1”.</translation>
    </message>
    <message>
        <source>%1: the controller has no such row of I/O groups.</source>
        <translation>%1: el controlador no tiene esa fila de grupos de E/S.</translation>
    </message>
    <message>
        <source>Instance of the first variable on this controller, 0 or 1 (parameter RS022).</source>
        <translation>Instancia de la primera variable en este controlador, 0 o 1 (parámetro RS022).</translation>
    </message>
    <message>
        <source>Print JSON.</source>
        <translation>Mostrar JSON.</translation>
    </message>
    <message>
        <source>Yes, write: what changes something does nothing without it.</source>
        <translation>Sí, escribir: lo que cambia algo no hace nada sin esta opción.</translation>
    </message>
    <message>
        <source>No progress and no remarks.</source>
        <translation>Sin progreso ni observaciones.</translation>
    </message>
    <message>
        <source>--numbering takes 0 or 1.</source>
        <translation>--numbering admite 0 o 1.</translation>
    </message>
    <message>
        <source>Name the controller with --host or --profile.</source>
        <translation>Indique el controlador con --host o --profile.</translation>
    </message>
    <message>
        <source>See pendeskctl %1 --help.</source>
        <translation>Consulte pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>This changes something at the controller or on this computer. Add --yes to do it.</source>
        <translation>Esto cambia algo en el controlador o en este equipo. Añada --yes para hacerlo.</translation>
    </message>
    <message>
        <source>Say what to read.</source>
        <translation>Indique qué se debe leer.</translation>
    </message>
    <message>
        <source>Positions are not written from the command line.</source>
        <translation>Las posiciones no se escriben desde la línea de comandos.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 no se puede escribir.</translation>
    </message>
    <message>
        <source>Nobody has verified which instance a variable has on this controller. Compare one value with the pendant, then say --numbering 0 or --numbering 1.</source>
        <translation>Nadie ha verificado qué instancia tiene una variable en este controlador. Compare un valor con la consola de programación y después indique --numbering 0 o --numbering 1.</translation>
    </message>
    <message>
        <source>Another value was read back: %1</source>
        <translation>Al volver a leer se obtuvo otro valor: %1</translation>
    </message>
    <message>
        <source>io set takes one signal, such as 27010, and 0 or 1.</source>
        <translation>io set admite una señal, por ejemplo 27010, y 0 o 1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: HSES writes network inputs alone.</source>
        <translation>%1 no se puede escribir: HSES solo escribe entradas de red.</translation>
    </message>
    <message>
        <source>Say “get NAME…” or “set NAME VALUE”.</source>
        <translation>Indique “get NAME…” o “set NAME VALUE”.</translation>
    </message>
    <message>
        <source>Reads model, system software and parameter version.</source>
        <translation>Lee el modelo, el software del sistema y la versión de parámetros.</translation>
    </message>
    <message>
        <source>In pulses instead of the base frame.</source>
        <translation>En pulsos en lugar del sistema de coordenadas base.</translation>
    </message>
    <message>
        <source>A list of the history instead: major, minor, user, system or offline.</source>
        <translation>En su lugar, una lista del historial: major, minor, user, system u offline.</translation>
    </message>
    <message>
        <source>Reads the active alarms, newest first.</source>
        <translation>Lee las alarmas activas, la más reciente primero.</translation>
    </message>
    <message>
        <source>--history takes major, minor, user, system or offline.</source>
        <translation>--history admite major, minor, user, system u offline.</translation>
    </message>
    <message>
        <source>Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input.</source>
        <translation>Lee filas de grupos de E/S (2701..2710) o señales (27010, IN#(1)); escribe una entrada de red.</translation>
    </message>
    <message>
        <source>Reads registers; writes one and reads it back.</source>
        <translation>Lee registros; escribe uno y lo vuelve a leer.</translation>
    </message>
    <message>
        <source>Reads variables B I D R S P BP EX; writes one and reads it back.</source>
        <translation>Lee variables B I D R S P BP EX; escribe una y la vuelve a leer.</translation>
    </message>
    <message>
        <source>Time between two readings: 1s, 200ms.</source>
        <translation>Tiempo entre dos lecturas: 1s, 200ms.</translation>
    </message>
    <message>
        <source>End after so many readings.</source>
        <translation>Terminar tras este número de lecturas.</translation>
    </message>
    <message>
        <source>Reads variables, registers (M005) and I/O again and again, one line of JSON with --json.</source>
        <translation>Lee variables, registros (M005) y E/S una y otra vez, una línea de JSON cada vez con --json.</translation>
    </message>
    <message>
        <source>Reads status, executing job, position and system information once.</source>
        <translation>Lee una vez el estado, el trabajo en ejecución, la posición y la información del sistema.</translation>
    </message>
    <message>
        <source>Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need --yes.</source>
        <translation>Lista, lee, envía y borra archivos. Los archivos enviados se vuelven a leer; antes de borrar un archivo se escribe aquí una copia. Lo existente lo sustituyen get con --yes y put con --replace; put y rm necesitan --yes.</translation>
    </message>
    <message>
        <source>The controller lists no file that “%1” matches.</source>
        <translation>El controlador no lista ningún archivo que coincida con «%1».</translation>
    </message>
    <message>
        <source>The controller is named with --host H, or with --profile NAME as Pendesk keeps it.</source>
        <translation>El controlador se indica con --host H, o con --profile NAME tal como lo guarda Pendesk.</translation>
    </message>
    <message>
        <source>What changes something does nothing without --yes.</source>
        <translation>Lo que cambia algo no hace nada sin --yes.</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,
5 local file error, 6 verification failed, 7 done in part.</source>
        <translation>Códigos de salida: 0 hecho, 1 diferencias, 2 llamada incorrecta, 3 sin respuesta o resultado desconocido, 4 rechazado,
5 error de archivo local, 6 verificación no superada, 7 hecho en parte.</translation>
    </message>
    <message>
        <source>Nobody has verified how this controller numbers its variables (parameter RS022), so these may be their neighbours. --numbering 0 or --numbering 1 settles it.</source>
        <translation>Nadie ha verificado cómo numera este controlador sus variables (parámetro RS022), así que estas pueden ser sus vecinas. --numbering 0 o --numbering 1 lo aclara.</translation>
    </message>
    <message>
        <source>Print this and end.</source>
        <translation>Mostrar esto y terminar.</translation>
    </message>
    <message>
        <source>Files restored: %1. The fresh backup is %2.</source>
        <translation>Archivos restaurados: %1. La copia de seguridad nueva es %2.</translation>
    </message>
    <message>
        <source>The software of the controller is another than that with which the numbering was verified. Verify it again, or say --numbering 0 or --numbering 1.</source>
        <translation>El software del controlador no es el mismo con el que se verificó la numeración. Verifíquela de nuevo, o indique --numbering 0 o --numbering 1.</translation>
    </message>
    <message>
        <source>Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.</source>
        <translation>Leer también ALL.PRM, que repite los demás archivos de parámetros y lleva 45 s en un controlador real.</translation>
    </message>
    <message>
        <source>The encoding of texts, such as Shift_JIS.</source>
        <translation>La codificación de los textos, por ejemplo Shift_JIS.</translation>
    </message>
    <message>
        <source>Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a controller would refuse one.</source>
        <translation>Examina trabajos como antes de enviarlos e imprime lo que es incorrecto o extraño; código de salida 1 si un controlador rechazaría alguno.</translation>
    </message>
    <message>
        <source>Say the files or a folder.</source>
        <translation>Indique los archivos o una carpeta.</translation>
    </message>
    <message>
        <source>“%1” is no encoding.</source>
        <translation>“%1” no es una codificación.</translation>
    </message>
    <message>
        <source>Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.</source>
        <translation>No se cuentan: %1 contadores, %2 registros, %3 archivos más con solo fechas, horas o líneas de control.</translation>
    </message>
    <message>
        <source>Count dates, counters, logs, blanks and line ends as differences too.</source>
        <translation>Contar también como diferencias fechas, contadores, registros, espacios y fines de línea.</translation>
    </message>
    <message>
        <source>Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if configuration or data differ.</source>
        <translation>Compara dos copias de seguridad o carpetas de archivos de controlador, o una con el controlador, en palabras; código de salida 1 si difieren la configuración o los datos.</translation>
    </message>
    <message>
        <source>The encoding of texts: %1.</source>
        <translation>La codificación de los textos: %1.</translation>
    </message>
    <message>
        <source>The controller model: %1.</source>
        <translation>El modelo del controlador: %1.</translation>
    </message>
    <message>
        <source>look at jobs before they are sent</source>
        <translation>examinar trabajos antes de enviarlos</translation>
    </message>
    <message>
        <source>tell what controller files say</source>
        <translation>explicar archivos de controlador</translation>
    </message>
    <message>
        <source>The encoding of the pendant&apos;s language instead of the stored one: %1.</source>
        <translation>La codificación del idioma de la consola de programación en lugar de la guardada: %1.</translation>
    </message>
    <message>
        <source>--encoding takes one of %1.</source>
        <translation>--encoding debe ser uno de estos: %1.</translation>
    </message>
    <message>
        <source>--%1 takes a whole number that is not negative.</source>
        <translation>--%1 admite un número entero no negativo.</translation>
    </message>
    <message>
        <source>%1 does not take “%2”. See pendeskctl %1 --help.</source>
        <translation>%1 no admite “%2”. Véase pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>%1 takes %2. See pendeskctl %1 --help.</source>
        <translation>%1 admite %2. Véase pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>Reads where a control group stands: the first robot, or R2, B1, S1.</source>
        <translation>Lee dónde está un grupo de control: el primer robot, o R2, B1, S1.</translation>
    </message>
    <message>
        <source>“%1” is no control group of a %2: say R1, B1 or S1.</source>
        <translation>“%1” no es un grupo de control de un %2: indique R1, B1 o S1.</translation>
    </message>
    <message>
        <source>The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names can be sent by their names.</source>
        <translation>La copia de seguridad (izquierda) es de un robot distinto al del controlador (derecha). No se envió nada. Se pueden enviar trabajos y nombres sueltos por su nombre.</translation>
    </message>
    <message>
        <source>Sends back what differs from a backup of the same robot: first a fresh backup beside it, then file by file, each read back. Tools, frames and areas only by name; parameters, calibration and ladder never; never while a job runs.</source>
        <translation>Devuelve lo que difiere de una copia de seguridad del mismo robot: primero una copia de seguridad nueva junto a ella, después archivo por archivo, volviendo a leer cada uno. Herramientas, sistemas de coordenadas y áreas solo por su nombre; parámetros, calibración y ladder nunca; nunca con un trabajo en marcha.</translation>
    </message>
    <message>
        <source>%1 bytes that are not a text.</source>
        <translation>%1 bytes que no son un texto.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>The encoding of the pendant.</source>
        <translation>La codificación de la consola.</translation>
    </message>
    <message>
        <source>Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. Addresses, users and passwords are masked.</source>
        <translation>Explica archivos de controlador: nombres, herramientas, sistemas de coordenadas, variables, parámetros, ladder, registros. Se ocultan direcciones, usuarios y contraseñas.</translation>
    </message>
    <message>
        <source>Say a backup, a folder or files.</source>
        <translation>Indique copia de seguridad, carpeta o archivos.</translation>
    </message>
    <message>
        <source>There is no encoding “%1”.</source>
        <translation>No existe la codificación “%1”.</translation>
    </message>
    <message>
        <source>--every takes a time such as 200ms or 1s.</source>
        <translation>--every admite un tiempo como 200ms o 1s.</translation>
    </message>
    <message>
        <source>Another signal of the group changed meanwhile; nothing was sent.</source>
        <translation>Entretanto cambió otra señal del grupo; no se envió nada.</translation>
    </message>
    <message>
        <source>not used in these files</source>
        <translation>sin uso en estos archivos</translation>
    </message>
    <message>
        <source>a job that is known when the line runs</source>
        <translation>un job que se conoce al ejecutar la línea</translation>
    </message>
    <message>
        <source>no file has it</source>
        <translation>ningún archivo lo contiene</translation>
    </message>
    <message>
        <source>Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in the ladder, in files of names.</source>
        <translation>Dice dónde se usan variables, señales, registros, herramientas, sistemas, macros, alarmas y jobs: en jobs, en el ladder y en archivos de nombres.</translation>
    </message>
    <message>
        <source>Say what to look for, such as B012, IN#(5) or a job.</source>
        <translation>Indique qué buscar, como B012, IN#(5) o un job.</translation>
    </message>
    <message>
        <source>Tells which job calls, jumps to or starts which, line by line.</source>
        <translation>Dice, línea a línea, qué job llama, salta o inicia a cuál.</translation>
    </message>
    <message>
        <source>Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, variables that are never written, tools that were not entered.</source>
        <translation>Dice qué merece revisarse: jobs que nada nombra, jobs que faltan, salidas con varios escritores, variables que nunca se escriben, herramientas sin introducir.</translation>
    </message>
    <message>
        <source>tell where variables, signals and jobs are used</source>
        <translation>decir dónde se usan variables, señales y jobs</translation>
    </message>
    <message>
        <source>tell which job calls which</source>
        <translation>decir qué job llama a cuál</translation>
    </message>
    <message>
        <source>tell what in the files is worth a look</source>
        <translation>decir qué merece revisarse en los archivos</translation>
    </message>
</context>
<context>
    <name>pendeskctl::AlarmReader</name>
    <message>
        <source>There are no alarms.</source>
        <translation>No hay alarmas.</translation>
    </message>
</context>
<context>
    <name>pendeskctl::Gap</name>
    <message>
        <source>Answers again after %1 s.</source>
        <translation>Responde de nuevo tras %1 s.</translation>
    </message>
</context>
<context>
    <name>protocol</name>
    <message>
        <source>refused with status %1, which is not in the code list</source>
        <translation>rechazado con el estado %1, que no figura en la lista de códigos</translation>
    </message>
    <message>
        <source>%1 refused, with a code that is not in the code list</source>
        <translation>%1 rechazado, con un código que no figura en la lista de códigos</translation>
    </message>
    <message>
        <source>the controller did not answer; nothing was changed</source>
        <translation>el controlador no respondió; no se cambió nada</translation>
    </message>
    <message>
        <source>no answer: it may or may not have happened — look at the robot</source>
        <translation>sin respuesta: puede haberse ejecutado o no — observe el robot</translation>
    </message>
    <message>
        <source>the answer does not fit the question</source>
        <translation>la respuesta no corresponde a la pregunta</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>no se envió nada</translation>
    </message>
    <message>
        <source>this computer&apos;s network refused</source>
        <translation>la red de este equipo lo rechazó</translation>
    </message>
    <message>
        <source>this cannot be sent to a controller</source>
        <translation>esto no se puede enviar a un controlador</translation>
    </message>
    <message>
        <source>a file on this computer could not be read or written</source>
        <translation>no se pudo leer o escribir un archivo de este equipo</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
    <message>
        <source>the command is faulty</source>
        <translation>el comando es erróneo</translation>
    </message>
    <message>
        <source>the command has the wrong number of operands</source>
        <translation>el comando tiene un número de operandos incorrecto</translation>
    </message>
    <message>
        <source>an operand is out of its range</source>
        <translation>un operando está fuera de su rango</translation>
    </message>
    <message>
        <source>an operand has the wrong length</source>
        <translation>un operando tiene una longitud incorrecta</translation>
    </message>
    <message>
        <source>the device holds too many files</source>
        <translation>el dispositivo contiene demasiados archivos</translation>
    </message>
    <message>
        <source>delete files that are not needed</source>
        <translation>borre los archivos que no se necesiten</translation>
    </message>
    <message>
        <source>the robot is running</source>
        <translation>el robot está en marcha</translation>
    </message>
    <message>
        <source>wait until it has stopped, or hold it</source>
        <translation>espere hasta que se haya parado o deténgalo con HOLD</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>en HOLD por la consola de programación</translation>
    </message>
    <message>
        <source>release HOLD on the pendant</source>
        <translation>libere HOLD en la consola de programación</translation>
    </message>
    <message>
        <source>held by the playback panel</source>
        <translation>en HOLD por el panel de reproducción</translation>
    </message>
    <message>
        <source>release HOLD on the panel or pendant</source>
        <translation>libere HOLD en el panel o en la consola de programación</translation>
    </message>
    <message>
        <source>held by an external signal</source>
        <translation>en HOLD por una señal externa</translation>
    </message>
    <message>
        <source>release the external hold signal</source>
        <translation>libere la señal externa de HOLD</translation>
    </message>
    <message>
        <source>held by a command</source>
        <translation>en HOLD por un comando</translation>
    </message>
    <message>
        <source>switch HOLD off</source>
        <translation>desactive HOLD</translation>
    </message>
    <message>
        <source>an alarm or error is present</source>
        <translation>hay una alarma o un error</translation>
    </message>
    <message>
        <source>remove its cause, then reset the alarm</source>
        <translation>elimine su causa y después restablezca la alarma</translation>
    </message>
    <message>
        <source>servo power is off</source>
        <translation>la alimentación de servos está desconectada</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>active Servo ON</translation>
    </message>
    <message>
        <source>the controller is in the wrong mode</source>
        <translation>el controlador está en un modo incorrecto</translation>
    </message>
    <message>
        <source>turn the pendant key to the mode needed, usually PLAY in REMOTE</source>
        <translation>gire la llave de la consola de programación al modo necesario, normalmente PLAY en REMOTE</translation>
    </message>
    <message>
        <source>the files are in use by another function</source>
        <translation>otra función está utilizando los archivos</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>inténtelo de nuevo en un momento</translation>
    </message>
    <message>
        <source>command remote is not enabled</source>
        <translation>el remoto por comando (command remote) no está habilitado</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and enable command remote</source>
        <translation>gire la llave de la consola de programación a REMOTE y habilite el remoto por comando (command remote)</translation>
    </message>
    <message>
        <source>this data may not be accessed</source>
        <translation>no se permite el acceso a estos datos</translation>
    </message>
    <message>
        <source>check the security mode and the data protection on the pendant</source>
        <translation>compruebe el modo de seguridad y la protección de datos en la consola de programación</translation>
    </message>
    <message>
        <source>this data may not be loaded</source>
        <translation>no se permite cargar estos datos</translation>
    </message>
    <message>
        <source>the data is being edited</source>
        <translation>los datos se están editando</translation>
    </message>
    <message>
        <source>leave the editor on the pendant</source>
        <translation>salga del editor en la consola de programación</translation>
    </message>
    <message>
        <source>a coordinate conversion is in progress</source>
        <translation>hay una conversión de coordenadas en curso</translation>
    </message>
    <message>
        <source>try again when it has ended</source>
        <translation>inténtelo de nuevo cuando haya terminado</translation>
    </message>
    <message>
        <source>servo power must be on first</source>
        <translation>primero debe estar conectada la alimentación de servos</translation>
    </message>
    <message>
        <source>the home position must be set or checked</source>
        <translation>la posición de origen se debe ajustar o comprobar</translation>
    </message>
    <message>
        <source>check the home position on the pendant</source>
        <translation>compruebe la posición de origen en la consola de programación</translation>
    </message>
    <message>
        <source>the position must be checked</source>
        <translation>la posición se debe comprobar</translation>
    </message>
    <message>
        <source>confirm the position on the pendant</source>
        <translation>confirme la posición en la consola de programación</translation>
    </message>
    <message>
        <source>the present position is not available</source>
        <translation>la posición actual no está disponible</translation>
    </message>
    <message>
        <source>the panel lock prohibits a change of mode or cycle</source>
        <translation>el bloqueo del panel prohíbe cambiar de modo o de ciclo</translation>
    </message>
    <message>
        <source>release the panel lock</source>
        <translation>libere el bloqueo del panel</translation>
    </message>
    <message>
        <source>the panel lock prohibits a start</source>
        <translation>el bloqueo del panel prohíbe un inicio</translation>
    </message>
    <message>
        <source>the user frame is not taught</source>
        <translation>el sistema de coordenadas de usuario no está enseñado</translation>
    </message>
    <message>
        <source>teach the user frame</source>
        <translation>enseñe el sistema de coordenadas de usuario</translation>
    </message>
    <message>
        <source>the user frame data is damaged</source>
        <translation>los datos del sistema de coordenadas de usuario están dañados</translation>
    </message>
    <message>
        <source>teach the user frame again</source>
        <translation>enseñe de nuevo el sistema de coordenadas de usuario</translation>
    </message>
    <message>
        <source>the control group is wrong</source>
        <translation>el grupo de control es incorrecto</translation>
    </message>
    <message>
        <source>choose a control group that this controller has</source>
        <translation>elija un grupo de control que tenga este controlador</translation>
    </message>
    <message>
        <source>the base axis data is wrong</source>
        <translation>los datos de los ejes base son incorrectos</translation>
    </message>
    <message>
        <source>a relative job may not be converted</source>
        <translation>no se permite convertir un trabajo relativo</translation>
    </message>
    <message>
        <source>permit the conversion on the pendant</source>
        <translation>permita la conversión en la consola de programación</translation>
    </message>
    <message>
        <source>a parameter prohibits calling the master job</source>
        <translation>un parámetro prohíbe llamar al trabajo maestro</translation>
    </message>
    <message>
        <source>permit the master call on the pendant</source>
        <translation>permita la llamada al trabajo maestro en la consola de programación</translation>
    </message>
    <message>
        <source>the master job may not be called while operating</source>
        <translation>no se permite llamar al trabajo maestro durante la operación</translation>
    </message>
    <message>
        <source>wait until the operation has ended</source>
        <translation>espere hasta que haya terminado la operación</translation>
    </message>
    <message>
        <source>the teach lock prohibits calling the master job</source>
        <translation>el bloqueo de enseñanza prohíbe llamar al trabajo maestro</translation>
    </message>
    <message>
        <source>release the teach lock</source>
        <translation>libere el bloqueo de enseñanza</translation>
    </message>
    <message>
        <source>robot calibration data is missing</source>
        <translation>faltan los datos de calibración del robot</translation>
    </message>
    <message>
        <source>calibrate the robots</source>
        <translation>calibre los robots</translation>
    </message>
    <message>
        <source>servo power cannot be switched on</source>
        <translation>la alimentación de servos no se puede conectar</translation>
    </message>
    <message>
        <source>check the safety chain: emergency stop, safeguards, alarms</source>
        <translation>compruebe la cadena de seguridad: parada de emergencia, dispositivos de protección, alarmas</translation>
    </message>
    <message>
        <source>the coordinate system cannot be set</source>
        <translation>el sistema de coordenadas no se puede ajustar</translation>
    </message>
    <message>
        <source>no memory is left for jobs</source>
        <translation>no queda memoria para trabajos</translation>
    </message>
    <message>
        <source>delete jobs that are not needed</source>
        <translation>borre los trabajos que no se necesiten</translation>
    </message>
    <message>
        <source>no memory is left for position data</source>
        <translation>no queda memoria para datos de posición</translation>
    </message>
    <message>
        <source>editing of this job is prohibited</source>
        <translation>la edición de este trabajo está prohibida</translation>
    </message>
    <message>
        <source>remove the edit lock of the job</source>
        <translation>quite el bloqueo de edición del trabajo</translation>
    </message>
    <message>
        <source>a job of that name exists</source>
        <translation>ya existe un trabajo con ese nombre</translation>
    </message>
    <message>
        <source>delete or rename it, or permit overwriting</source>
        <translation>bórrelo o cambie su nombre, o permita sobrescribir</translation>
    </message>
    <message>
        <source>the job was not found</source>
        <translation>no se encontró el trabajo</translation>
    </message>
    <message>
        <source>check the job name</source>
        <translation>compruebe el nombre del trabajo</translation>
    </message>
    <message>
        <source>no job is set for execution</source>
        <translation>no hay ningún trabajo establecido para la ejecución</translation>
    </message>
    <message>
        <source>select a job first</source>
        <translation>seleccione primero un trabajo</translation>
    </message>
    <message>
        <source>position data is damaged</source>
        <translation>los datos de posición están dañados</translation>
    </message>
    <message>
        <source>load the job again from a backup</source>
        <translation>cargue de nuevo el trabajo desde una copia de seguridad</translation>
    </message>
    <message>
        <source>position data is missing</source>
        <translation>faltan datos de posición</translation>
    </message>
    <message>
        <source>teach the missing position</source>
        <translation>enseñe la posición que falta</translation>
    </message>
    <message>
        <source>the position variable has the wrong type</source>
        <translation>la variable de posición tiene un tipo incorrecto</translation>
    </message>
    <message>
        <source>write the type that the variable is declared with</source>
        <translation>escriba el tipo con el que está declarada la variable</translation>
    </message>
    <message>
        <source>END was reached in a job that is not the master</source>
        <translation>se alcanzó END en un trabajo que no es el maestro</translation>
    </message>
    <message>
        <source>instruction data is damaged</source>
        <translation>los datos de la instrucción están dañados</translation>
    </message>
    <message>
        <source>the job name has a character that is not allowed</source>
        <translation>el nombre del trabajo tiene un carácter no permitido</translation>
    </message>
    <message>
        <source>rename the job</source>
        <translation>cambie el nombre del trabajo</translation>
    </message>
    <message>
        <source>a label has a character that is not allowed</source>
        <translation>una etiqueta tiene un carácter no permitido</translation>
    </message>
    <message>
        <source>rename the label</source>
        <translation>cambie el nombre de la etiqueta</translation>
    </message>
    <message>
        <source>this system does not have the instruction</source>
        <translation>este sistema no tiene la instrucción</translation>
    </message>
    <message>
        <source>the job to convert has no steps</source>
        <translation>el trabajo que se debe convertir no tiene pasos</translation>
    </message>
    <message>
        <source>the job is converted already</source>
        <translation>el trabajo ya está convertido</translation>
    </message>
    <message>
        <source>the user frame must be taught</source>
        <translation>el sistema de coordenadas de usuario se debe enseñar</translation>
    </message>
    <message>
        <source>relative jobs or independent control are not permitted</source>
        <translation>no se permiten trabajos relativos o control independiente</translation>
    </message>
    <message>
        <source>an instruction has a syntax error</source>
        <translation>una instrucción tiene un error de sintaxis</translation>
    </message>
    <message>
        <source>correct the instruction</source>
        <translation>corrija la instrucción</translation>
    </message>
    <message>
        <source>the position data has an error</source>
        <translation>los datos de posición tienen un error</translation>
    </message>
    <message>
        <source>correct the position section</source>
        <translation>corrija la sección de posiciones</translation>
    </message>
    <message>
        <source>NOP or END is missing</source>
        <translation>falta NOP o END</translation>
    </message>
    <message>
        <source>begin the instructions with NOP and end them with END</source>
        <translation>empiece las instrucciones con NOP y termínelas con END</translation>
    </message>
    <message>
        <source>the format is wrong</source>
        <translation>el formato es incorrecto</translation>
    </message>
    <message>
        <source>the number of data is wrong</source>
        <translation>el número de datos es incorrecto</translation>
    </message>
    <message>
        <source>correct the counts in the NPOS line</source>
        <translation>corrija los recuentos de la línea NPOS</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>un valor está fuera de rango</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>corrija el valor</translation>
    </message>
    <message>
        <source>there is a syntax error outside the instructions</source>
        <translation>hay un error de sintaxis fuera de las instrucciones</translation>
    </message>
    <message>
        <source>correct the header of the file</source>
        <translation>corrija el encabezado del archivo</translation>
    </message>
    <message>
        <source>a pseudo instruction is wrong</source>
        <translation>una pseudoinstrucción es incorrecta</translation>
    </message>
    <message>
        <source>correct the line that starts with slashes</source>
        <translation>corrija la línea que empieza con barras</translation>
    </message>
    <message>
        <source>a record of a condition file has an error</source>
        <translation>un registro de un archivo de condiciones tiene un error</translation>
    </message>
    <message>
        <source>a record of a job has an error</source>
        <translation>un registro de un trabajo tiene un error</translation>
    </message>
    <message>
        <source>the data comes from a different system</source>
        <translation>los datos proceden de otro sistema</translation>
    </message>
    <message>
        <source>the welding type does not match</source>
        <translation>el tipo de soldadura no coincide</translation>
    </message>
    <message>
        <source>the robot or station is operating</source>
        <translation>el robot o la estación está en operación</translation>
    </message>
    <message>
        <source>back up when nothing moves</source>
        <translation>haga la copia de seguridad cuando nada se mueva</translation>
    </message>
    <message>
        <source>the device has too little memory</source>
        <translation>el dispositivo tiene muy poca memoria</translation>
    </message>
    <message>
        <source>free memory on the device or use a larger one</source>
        <translation>libere memoria en el dispositivo o utilice uno mayor</translation>
    </message>
    <message>
        <source>the device cannot be accessed</source>
        <translation>no se puede acceder al dispositivo</translation>
    </message>
    <message>
        <source>check that the device is inserted</source>
        <translation>compruebe que el dispositivo está insertado</translation>
    </message>
    <message>
        <source>a backup was not expected now</source>
        <translation>no se esperaba una copia de seguridad ahora</translation>
    </message>
    <message>
        <source>the image is larger than the RAM area</source>
        <translation>la imagen es mayor que el área de RAM</translation>
    </message>
    <message>
        <source>enlarge the RAM area for backups</source>
        <translation>amplíe el área de RAM para copias de seguridad</translation>
    </message>
    <message>
        <source>no memory was reserved at power-on</source>
        <translation>no se reservó memoria en el encendido</translation>
    </message>
    <message>
        <source>switch the controller off and on</source>
        <translation>apague y vuelva a encender el controlador</translation>
    </message>
    <message>
        <source>the backup file information cannot be accessed</source>
        <translation>no se puede acceder a la información del archivo de copia de seguridad</translation>
    </message>
    <message>
        <source>the old backup could not be removed</source>
        <translation>no se pudo eliminar la copia de seguridad antigua</translation>
    </message>
    <message>
        <source>the backup could not be renamed</source>
        <translation>no se pudo cambiar el nombre de la copia de seguridad</translation>
    </message>
    <message>
        <source>the drive name is too long</source>
        <translation>el nombre de la unidad es demasiado largo</translation>
    </message>
    <message>
        <source>the device is the wrong one</source>
        <translation>el dispositivo no es el correcto</translation>
    </message>
    <message>
        <source>set the automatic backup to the RAM disk</source>
        <translation>ajuste la copia de seguridad automática al disco RAM</translation>
    </message>
    <message>
        <source>a system error occurred</source>
        <translation>se produjo un error del sistema</translation>
    </message>
    <message>
        <source>automatic backup is not available</source>
        <translation>la copia de seguridad automática no está disponible</translation>
    </message>
    <message>
        <source>set up automatic backup on the pendant</source>
        <translation>configure la copia de seguridad automática en la consola de programación</translation>
    </message>
    <message>
        <source>an automatic backup is running</source>
        <translation>hay una copia de seguridad automática en curso</translation>
    </message>
    <message>
        <source>the controller does not know this command</source>
        <translation>el controlador no conoce este comando</translation>
    </message>
    <message>
        <source>the number does not exist on this controller</source>
        <translation>el número no existe en este controlador</translation>
    </message>
    <message>
        <source>check the number and the variable numbering</source>
        <translation>compruebe el número y la numeración de variables</translation>
    </message>
    <message>
        <source>the element does not exist on this controller</source>
        <translation>el elemento no existe en este controlador</translation>
    </message>
    <message>
        <source>the reply would be too large for the hardware</source>
        <translation>la respuesta sería demasiado grande para el hardware</translation>
    </message>
    <message>
        <source>ask for less at once</source>
        <translation>solicite menos a la vez</translation>
    </message>
    <message>
        <source>the reply would be too large</source>
        <translation>la respuesta sería demasiado grande</translation>
    </message>
    <message>
        <source>the position variable is not defined</source>
        <translation>la variable de posición no está definida</translation>
    </message>
    <message>
        <source>teach or write it first</source>
        <translation>enséñela o escríbala primero</translation>
    </message>
    <message>
        <source>this data may not be used</source>
        <translation>no se permite utilizar estos datos</translation>
    </message>
    <message>
        <source>the size of the request data is wrong</source>
        <translation>el tamaño de los datos de la solicitud es incorrecto</translation>
    </message>
    <message>
        <source>the data is not set</source>
        <translation>los datos no están ajustados</translation>
    </message>
    <message>
        <source>set it first</source>
        <translation>ajústelos primero</translation>
    </message>
    <message>
        <source>the application is not registered</source>
        <translation>la aplicación no está registrada</translation>
    </message>
    <message>
        <source>the type is not registered</source>
        <translation>el tipo no está registrado</translation>
    </message>
    <message>
        <source>the control group setting is wrong</source>
        <translation>el ajuste del grupo de control es incorrecto</translation>
    </message>
    <message>
        <source>name either robots or stations that this controller has</source>
        <translation>indique robots o estaciones que tenga este controlador</translation>
    </message>
    <message>
        <source>the speed setting is wrong</source>
        <translation>el ajuste de velocidad es incorrecto</translation>
    </message>
    <message>
        <source>use percent for joint and mm/s or °/s for straight moves</source>
        <translation>utilice porcentaje para movimientos articulares y mm/s o °/s para movimientos lineales</translation>
    </message>
    <message>
        <source>no speed is given</source>
        <translation>no se ha indicado ninguna velocidad</translation>
    </message>
    <message>
        <source>give a speed above 0</source>
        <translation>indique una velocidad mayor que 0</translation>
    </message>
    <message>
        <source>the coordinate system setting is wrong</source>
        <translation>el ajuste del sistema de coordenadas es incorrecto</translation>
    </message>
    <message>
        <source>the type or form setting is wrong</source>
        <translation>el ajuste de tipo o de forma es incorrecto</translation>
    </message>
    <message>
        <source>the tool number is wrong</source>
        <translation>el número de herramienta es incorrecto</translation>
    </message>
    <message>
        <source>use 0 to 63</source>
        <translation>utilice de 0 a 63</translation>
    </message>
    <message>
        <source>the user frame number is wrong</source>
        <translation>el número del sistema de coordenadas de usuario es incorrecto</translation>
    </message>
    <message>
        <source>use 1 to 63 with a user frame, else 0</source>
        <translation>utilice de 1 a 63 con un sistema de coordenadas de usuario; si no, 0</translation>
    </message>
    <message>
        <source>internal error of the controller: data area</source>
        <translation>error interno del controlador: área de datos</translation>
    </message>
    <message>
        <source>internal error of the controller: reply area exceeded</source>
        <translation>error interno del controlador: área de respuesta excedida</translation>
    </message>
    <message>
        <source>internal error of the controller: element size mismatch</source>
        <translation>error interno del controlador: el tamaño del elemento no coincide</translation>
    </message>
    <message>
        <source>internal error of the controller: customised function</source>
        <translation>error interno del controlador: función personalizada</translation>
    </message>
    <message>
        <source>another error</source>
        <translation>otro error</translation>
    </message>
    <message>
        <source>busy with another command</source>
        <translation>ocupado con otro comando</translation>
    </message>
    <message>
        <source>another access is in progress</source>
        <translation>hay otro acceso en curso</translation>
    </message>
    <message>
        <source>the backup parameter setting is wrong</source>
        <translation>el ajuste de los parámetros de copia de seguridad es incorrecto</translation>
    </message>
    <message>
        <source>the backup file was not created</source>
        <translation>no se creó el archivo de copia de seguridad</translation>
    </message>
    <message>
        <source>check that the controller is in remote mode</source>
        <translation>compruebe que el controlador está en modo remoto</translation>
    </message>
    <message>
        <source>internal system error of the controller</source>
        <translation>error interno del sistema del controlador</translation>
    </message>
    <message>
        <source>the transfer was dropped: nothing came in time</source>
        <translation>la transferencia se interrumpió: no llegó nada a tiempo</translation>
    </message>
    <message>
        <source>start the transfer again</source>
        <translation>inicie de nuevo la transferencia</translation>
    </message>
    <message>
        <source>the file cannot be overwritten</source>
        <translation>el archivo no se puede sobrescribir</translation>
    </message>
    <message>
        <source>permit overwriting, or delete the file first</source>
        <translation>permita sobrescribir o borre primero el archivo</translation>
    </message>
    <message>
        <source>the file is missing or empty</source>
        <translation>el archivo falta o está vacío</translation>
    </message>
    <message>
        <source>check the file name</source>
        <translation>compruebe el nombre del archivo</translation>
    </message>
    <message>
        <source>the path is wrong</source>
        <translation>la ruta es incorrecta</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>compruebe la ruta</translation>
    </message>
    <message>
        <source>the file is not in the list</source>
        <translation>el archivo no está en la lista</translation>
    </message>
    <message>
        <source>the file may not be deleted</source>
        <translation>no se permite borrar el archivo</translation>
    </message>
    <message>
        <source>the directory may not be deleted</source>
        <translation>no se permite borrar el directorio</translation>
    </message>
    <message>
        <source>files cannot be accessed while remote is off</source>
        <translation>no se puede acceder a los archivos mientras el modo remoto está desactivado</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>no se encontró el archivo</translation>
    </message>
    <message>
        <source>the path is too long</source>
        <translation>la ruta es demasiado larga</translation>
    </message>
    <message>
        <source>use a shorter name</source>
        <translation>utilice un nombre más corto</translation>
    </message>
    <message>
        <source>packet without data</source>
        <translation>paquete sin datos</translation>
    </message>
    <message>
        <source>packet too large</source>
        <translation>paquete demasiado grande</translation>
    </message>
    <message>
        <source>packet of size 0</source>
        <translation>paquete de tamaño 0</translation>
    </message>
    <message>
        <source>packet with a wrong block number</source>
        <translation>paquete con número de bloque incorrecto</translation>
    </message>
    <message>
        <source>packet with a wrong ACK byte</source>
        <translation>paquete con byte ACK incorrecto</translation>
    </message>
    <message>
        <source>packet of a wrong division</source>
        <translation>paquete de una división incorrecta</translation>
    </message>
    <message>
        <source>check that robot and file port are not exchanged</source>
        <translation>compruebe que el puerto del robot y el de archivos no están intercambiados</translation>
    </message>
    <message>
        <source>packet with a wrong access level</source>
        <translation>paquete con nivel de acceso incorrecto</translation>
    </message>
    <message>
        <source>packet with a wrong header size</source>
        <translation>paquete con tamaño de encabezado incorrecto</translation>
    </message>
    <message>
        <source>packet with a wrong identifier</source>
        <translation>paquete con identificador incorrecto</translation>
    </message>
    <message>
        <source>announced and received packet sizes differ</source>
        <translation>el tamaño de paquete anunciado y el recibido difieren</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>demasiadas solicitudes</translation>
    </message>
    <message>
        <source>ask less often, or try again in a moment</source>
        <translation>solicite con menos frecuencia o inténtelo de nuevo en un momento</translation>
    </message>
    <message>
        <source>the mode was changed and the communication dropped</source>
        <translation>se cambió el modo y se interrumpió la comunicación</translation>
    </message>
    <message>
        <source>start again in the new mode</source>
        <translation>empiece de nuevo en el modo nuevo</translation>
    </message>
</context>
<context>
    <name>robot::Controller</name>
    <message>
        <source>The name %1 is not known to this computer.</source>
        <translation>Este equipo no conoce el nombre %1.</translation>
    </message>
</context>
<context>
    <name>robot::Diagnosis</name>
    <message>
        <source>Host name</source>
        <translation>Nombre de host</translation>
    </message>
    <message>
        <source>Way to the host</source>
        <translation>Camino al host</translation>
    </message>
    <message>
        <source>Robot port</source>
        <translation>Puerto del robot</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>Información del sistema</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Puerto de archivos</translation>
    </message>
    <message>
        <source>Not looked at, because the step before it failed.</source>
        <translation>No se comprobó, porque el paso anterior falló.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address on this computer.</source>
        <translation>El nombre “%1” no tiene dirección IPv4 en este equipo.</translation>
    </message>
    <message>
        <source>Check the spelling, or enter the controller&apos;s IPv4 address as the pendant shows it.</source>
        <translation>Compruebe la ortografía o introduzca la dirección IPv4 del controlador tal como la muestra la consola de programación.</translation>
    </message>
    <message>
        <source>%1 is %2.</source>
        <translation>%1 es %2.</translation>
    </message>
    <message>
        <source>This computer cannot send to %1: %2.</source>
        <translation>Este equipo no puede enviar a %1: %2.</translation>
    </message>
    <message>
        <source>Check the cable and this computer&apos;s IPv4 address: it must be in the controller&apos;s network.</source>
        <translation>Compruebe el cable y la dirección IPv4 de este equipo: debe estar en la red del controlador.</translation>
    </message>
    <message>
        <source>This computer can send to %1.</source>
        <translation>Este equipo puede enviar a %1.</translation>
    </message>
    <message>
        <source>Port %1 answers with a status.</source>
        <translation>El puerto %1 responde con un estado.</translation>
    </message>
    <message>
        <source>Port %1 answers but refuses to tell the status: %2</source>
        <translation>El puerto %1 responde, pero se niega a comunicar el estado: %2</translation>
    </message>
    <message>
        <source>Check on the pendant that the network function server is enabled for this computer.</source>
        <translation>Compruebe en la consola de programación que el servidor de funciones de red está habilitado para este equipo.</translation>
    </message>
    <message>
        <source>Answers come from another address than %1; they are ignored.</source>
        <translation>Las respuestas llegan de una dirección distinta de %1; se ignoran.</translation>
    </message>
    <message>
        <source>Look for a second network card or an address translation between this computer and the controller.</source>
        <translation>Busque una segunda tarjeta de red o una traducción de direcciones entre este equipo y el controlador.</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not with HSES.</source>
        <translation>Algo responde en el puerto %1, pero no con HSES.</translation>
    </message>
    <message>
        <source>Check the address and the port: HSES is UDP %1 on a controller.</source>
        <translation>Compruebe la dirección y el puerto: HSES es UDP %1 en un controlador.</translation>
    </message>
    <message>
        <source>The host rejects port %1: %2.</source>
        <translation>El host rechaza el puerto %1: %2.</translation>
    </message>
    <message>
        <source>The host is there, but no HSES server: enable the Ethernet server function on the controller.</source>
        <translation>El host está ahí, pero no hay servidor HSES: habilite la función de servidor Ethernet en el controlador.</translation>
    </message>
    <message>
        <source>Port %1 stays silent.</source>
        <translation>El puerto %1 no responde.</translation>
    </message>
    <message>
        <source>Check that the controller is on, that its Ethernet server function is enabled and that no firewall drops UDP %1.</source>
        <translation>Compruebe que el controlador está encendido, que su función de servidor Ethernet está habilitada y que ningún cortafuegos descarta UDP %1.</translation>
    </message>
    <message>
        <source>The controller runs %1.</source>
        <translation>El controlador ejecuta %1.</translation>
    </message>
    <message>
        <source>The controller does not tell its system information: %1</source>
        <translation>El controlador no comunica su información del sistema: %1</translation>
    </message>
    <message>
        <source>Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option.</source>
        <translation>Pendesk supervisa únicamente un controlador que indique qué es. Consulte a su fabricante por la opción HSES.</translation>
    </message>
    <message>
        <source>Port %1 stays silent: files are unavailable, monitoring works.</source>
        <translation>El puerto %1 no responde: los archivos no están disponibles, la supervisión funciona.</translation>
    </message>
    <message>
        <source>Check that no firewall drops UDP %1.</source>
        <translation>Compruebe que ningún cortafuegos descarta UDP %1.</translation>
    </message>
    <message>
        <source>Port %1 answers.</source>
        <translation>El puerto %1 responde.</translation>
    </message>
</context>
<context>
    <name>session::FileSession</name>
    <message>
        <source>An empty file cannot be sent over HSES.</source>
        <translation>Un archivo vacío no se puede enviar por HSES.</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1 debe ser un número entero de %2 a %3.</translation>
    </message>
    <message>
        <source>The model “%1” is not known.</source>
        <translation>No se conoce el modelo “%1”.</translation>
    </message>
    <message>
        <source>The text encoding “%1” is not known.</source>
        <translation>No se conoce la codificación de texto “%1”.</translation>
    </message>
    <message>
        <source>The variable numbering must be 0 or 1.</source>
        <translation>La numeración de variables debe ser 0 o 1.</translation>
    </message>
    <message>
        <source>Pulses per degree must be lists of numbers, one list for each control group.</source>
        <translation>Los pulsos por grado deben ser listas de números, una lista por cada grupo de control.</translation>
    </message>
    <message>
        <source>The profile needs a name.</source>
        <translation>El perfil necesita un nombre.</translation>
    </message>
    <message>
        <source>The profile needs the controller&apos;s host name or IPv4 address.</source>
        <translation>El perfil necesita el nombre de host o la dirección IPv4 del controlador.</translation>
    </message>
</context>
<context>
    <name>settings::CommandLine</name>
    <message>
        <source>--%1 must be a whole number from 1 to 65535.</source>
        <translation>--%1 debe ser un número entero de 1 a 65535.</translation>
    </message>
    <message>
        <source>--timeout takes a time such as 300ms or 1s.</source>
        <translation>--timeout admite un tiempo como 300ms o 1s.</translation>
    </message>
    <message>
        <source>There is no controller stored under the name “%1”.</source>
        <translation>No hay ningún controlador guardado con el nombre “%1”.</translation>
    </message>
    <message>
        <source>Connect to the controller with this name or IPv4 address.</source>
        <translation>Conectar con el controlador que tiene este nombre o esta dirección IPv4.</translation>
    </message>
    <message>
        <source>Its port for robot control, 10040 unless told otherwise.</source>
        <translation>Su puerto para el control del robot, 10040 si no se indica otro.</translation>
    </message>
    <message>
        <source>Its port for file control, 10041 unless told otherwise.</source>
        <translation>Su puerto para el control de archivos, 10041 si no se indica otro.</translation>
    </message>
    <message>
        <source>Connect to the controller that is stored under this name.</source>
        <translation>Conectar con el controlador guardado con este nombre.</translation>
    </message>
    <message>
        <source>How long to wait for one try of a read: 300ms, 1s.</source>
        <translation>Cuánto se espera en cada intento de lectura: 300ms, 1s.</translation>
    </message>
    <message>
        <source>--%1 needs --host or --profile.</source>
        <translation>--%1 necesita --host o --profile.</translation>
    </message>
    <message>
        <source>--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>--model debe ser dx100, dx200, fs100, yrc1000 o yrc1000micro.</translation>
    </message>
    <message>
        <source>Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>Su modelo: dx100, dx200, fs100, yrc1000 o yrc1000micro.</translation>
    </message>
    <message>
        <source>What to log, as &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</source>
        <translation>Qué se registra, por ejemplo &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</translation>
    </message>
</context>
<context>
    <name>settings::Profile</name>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Puerto de archivos</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>Tiempo límite de lectura</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>Tiempo límite de archivos</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>Tiempo límite del servo</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>Repeticiones de una lectura</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>Solicitudes pendientes a la vez</translation>
    </message>
    <message>
        <source>Requests a second</source>
        <translation>Solicitudes por segundo</translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message>
        <source>The last good ones, of %1, are used.</source>
        <translation>Se utilizan los últimos correctos, de %1.</translation>
    </message>
    <message>
        <source>There is no good copy of them.</source>
        <translation>No hay ninguna copia correcta de ellos.</translation>
    </message>
    <message>
        <source>The settings in %1 are gone.</source>
        <translation>Los ajustes de %1 han desaparecido.</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1.</source>
        <translation>No se pueden leer los ajustes: %1.</translation>
    </message>
    <message>
        <source>The settings are damaged; they are kept as %1.</source>
        <translation>Los ajustes están dañados; se conservan como %1.</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>otro programa tiene ocupado %1</translation>
    </message>
    <message>
        <source>Settings could not be saved in time and are lost: %1</source>
        <translation>Los ajustes no se pudieron guardar a tiempo y se han perdido: %1</translation>
    </message>
    <message>
        <source>Settings cannot be saved: %1. Work goes on; it is tried again.</source>
        <translation>No se pueden guardar los ajustes: %1. El trabajo continúa; se vuelve a intentar.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>No se puede leer %n entrada de los ajustes anteriores; permanece en %1.</numerusform>
            <numerusform>No se pueden leer %n entradas de los ajustes anteriores; permanecen en %1.</numerusform>
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
            <numerusform>No se aplicó %n valor preparado.</numerusform>
            <numerusform>No se aplicaron %n valores preparados.</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are still being transferred.</source>
        <translation>Todavía se están transfiriendo archivos.</translation>
    </message>
    <message>
        <source>Files are still being read or sent for a backup, a comparison or a restore.</source>
        <translation>Aún se leen o envían archivos para una copia de seguridad, una comparación o una restauración.</translation>
    </message>
</context>
<context>
    <name>trend</name>
    <message>
        <source>Alarm %1 [%2] %3</source>
        <translation>Alarma %1 [%2] %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Trabajo %1</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>Modo paso</translation>
    </message>
    <message>
        <source>One cycle</source>
        <translation>Un ciclo</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continuo</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Límite de velocidad</translation>
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
        <translation>En HOLD por la consola de programación</translation>
    </message>
    <message>
        <source>Held externally</source>
        <translation>En HOLD externo</translation>
    </message>
    <message>
        <source>Held by command</source>
        <translation>En HOLD por comando</translation>
    </message>
    <message>
        <source>Alarm active</source>
        <translation>Alarma activa</translation>
    </message>
    <message>
        <source>Error active</source>
        <translation>Error activo</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ON</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Línea del trabajo</translation>
    </message>
    <message>
        <source>Job step</source>
        <translation>Paso del trabajo</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Override de velocidad</translation>
    </message>
    <message>
        <source>%1, sub task %2</source>
        <translation>%1, subtarea %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 following error</source>
        <translation>%1 %2 error de seguimiento</translation>
    </message>
    <message>
        <source>%1 %2 torque</source>
        <translation>%1 %2 par</translation>
    </message>
    <message>
        <source>%1 %2 encoder temperature</source>
        <translation>%1 %2 temperatura del encoder</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>pulsos</translation>
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
        <translation>Temperatura del convertidor, placa %1</translation>
    </message>
    <message>
        <source>Running time %1</source>
        <translation>Tiempo de marcha %1</translation>
    </message>
    <message>
        <source>Alarm code %1</source>
        <translation>Código de alarma %1</translation>
    </message>
</context>
<context>
    <name>trend::Recorder</name>
    <message>
        <source>An incident is lost: %1 could not be written in time.</source>
        <translation>Se ha perdido un incidente: %1 no se pudo escribir a tiempo.</translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message>
        <source>Passcode and idle time…</source>
        <translation>Contraseña y tiempo de inactividad…</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>Nivel de acceso: %1</translation>
    </message>
    <message>
        <source>This program was started with --monitor-only: it watches and holds.</source>
        <translation>Este programa se inició con --monitor-only: observa y puede enviar HOLD.</translation>
    </message>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>Lo que se puede hacer desde aquí. Vuelve a Supervisión tras %n minuto sin teclado ni ratón.</numerusform>
            <numerusform>Lo que se puede hacer desde aquí. Vuelve a Supervisión tras %n minutos sin teclado ni ratón.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Announcer</name>
    <message>
        <source>New alarm %1: %2</source>
        <translation>Alarma nueva %1: %2</translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message>
        <source>This controller is armed: press to disarm.</source>
        <translation>Este controlador está armado: pulse para desarmar.</translation>
    </message>
    <message>
        <source>ARMED · %1 s</source>
        <translation>ARMADO · %1 s</translation>
    </message>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>Armado durante %n segundo más. Pulse para desarmar.</numerusform>
            <numerusform>Armado durante %n segundos más. Pulse para desarmar.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message>
        <source>No backup</source>
        <translation>Sin copia de seguridad</translation>
    </message>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>Copia de hace %n hora</numerusform>
            <numerusform>Copia de hace %n horas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>Copia de hace %n día</numerusform>
            <numerusform>Copia de hace %n días</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>Copia antigua: %n día</numerusform>
            <numerusform>Copia antigua: %n días</numerusform>
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
        <translation>HLOCK está activado en %1: la consola de programación está bloqueada, excepto su parada de emergencia.</translation>
    </message>
    <message>
        <source>Release HLOCK</source>
        <translation>Liberar HLOCK</translation>
    </message>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>El diario vuelve a funcionar. Se perdió %n registro.</numerusform>
            <numerusform>El diario vuelve a funcionar. Se perdieron %n registros.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal was damaged. It was kept as %1, and a new one was begun.</source>
        <translation>El diario estaba dañado. Se conservó como %1 y se empezó uno nuevo.</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Level: %1</source>
        <translation>Nivel: %1</translation>
    </message>
    <message>
        <source>HLOCK is on</source>
        <translation>HLOCK está activado</translation>
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
        <translation>No se pudo iniciar la demo: %1.</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>Acerca de Pendesk</translation>
    </message>
    <message>
        <source>Pendesk %1

A teach and monitor desk for Yaskawa robot controllers.
Free software under the GNU General Public License, version 3 or later.

HOLD is a software hold over the network, not a safety function.</source>
        <translation>Pendesk %1

Un puesto para enseñar y supervisar controladores de robot Yaskawa.
Software libre bajo la GNU General Public License, versión 3 o posterior.

HOLD es una retención por software a través de la red, no una función de seguridad.</translation>
    </message>
    <message>
        <source>There is no connection.</source>
        <translation>No hay conexión.</translation>
    </message>
    <message>
        <source>The connection is open.</source>
        <translation>La conexión está abierta.</translation>
    </message>
    <message>
        <source>No controller is chosen.</source>
        <translation>No se ha elegido ningún controlador.</translation>
    </message>
    <message>
        <source>No controller is chosen: connect first.</source>
        <translation>No se ha elegido ningún controlador: conéctese primero.</translation>
    </message>
    <message>
        <source>%1 requests/s</source>
        <translation>%1 solicitudes/s</translation>
    </message>
    <message>
        <source>Something is unfinished</source>
        <translation>Hay algo sin terminar</translation>
    </message>
    <message>
        <source>Go on and lose it</source>
        <translation>Continuar y perderlo</translation>
    </message>
    <message>
        <source>HLOCK is still on at %1: the pendant stays locked out if you go on.</source>
        <translation>HLOCK sigue activado en %1: la consola de programación seguirá bloqueada si continúa.</translation>
    </message>
    <message>
        <source>Release HLOCK and go on</source>
        <translation>Liberar HLOCK y continuar</translation>
    </message>
    <message>
        <source>Go on and leave it on</source>
        <translation>Continuar y dejarlo activado</translation>
    </message>
</context>
<context>
    <name>ui::NavigationRail</name>
    <message>
        <source>CONTROLLERS</source>
        <translation>CONTROLADORES</translation>
    </message>
    <message>
        <source>PAGES</source>
        <translation>PÁGINAS</translation>
    </message>
    <message>
        <source>CONNECTION</source>
        <translation>CONEXIÓN</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
</context>
<context>
    <name>ui::RobotStrip</name>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULACIÓN</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Enlace</translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>Ningún controlador</translation>
    </message>
    <message>
        <source>Link · %1 ago</source>
        <translation>Enlace · hace %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>PERDIDO</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>comprobando…</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>no conectado</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcha</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Job · %1</source>
        <translation>Trabajo · %1</translation>
    </message>
</context>
<context>
    <name>ui::StationList</name>
    <message numerus="yes">
        <source>%n more in Fleet</source>
        <translation>
            <numerusform>%n más en Flota</numerusform>
            <numerusform>%n más en Flota</numerusform>
        </translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>Ningún controlador</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>no conectado</translation>
    </message>
</context>
<context>
    <name>values</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>number</source>
        <translation>número</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>ejes</translation>
    </message>
    <message>
        <source>conveyor files</source>
        <translation>archivos de transportador</translation>
    </message>
    <message>
        <source>robots and stations</source>
        <translation>robots y estaciones</translation>
    </message>
    <message>
        <source>signed number</source>
        <translation>número con signo</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>robots</source>
        <translation>robots</translation>
    </message>
    <message>
        <source>robots, stations and bases</source>
        <translation>robots, estaciones y bases</translation>
    </message>
    <message>
        <source>control group, low and high axes</source>
        <translation>grupo de control, ejes inferiores y superiores</translation>
    </message>
    <message>
        <source>control group, minimum and maximum axes</source>
        <translation>grupo de control, ejes mínimos y máximos</translation>
    </message>
    <message>
        <source>control group, minimum and maximum X Y Z</source>
        <translation>grupo de control, X Y Z mínimos y máximos</translation>
    </message>
    <message>
        <source>axes of two control groups</source>
        <translation>ejes de dos grupos de control</translation>
    </message>
    <message>
        <source>two sets of axes of a control group</source>
        <translation>dos conjuntos de ejes de un grupo de control</translation>
    </message>
    <message>
        <source>axes of a control group and a number</source>
        <translation>ejes de un grupo de control y un número</translation>
    </message>
    <message>
        <source>control group and a number</source>
        <translation>grupo de control y un número</translation>
    </message>
    <message>
        <source>unknown type %1</source>
        <translation>tipo desconocido %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>delante</translation>
    </message>
    <message>
        <source>back</source>
        <translation>detrás</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>brazo superior</translation>
    </message>
    <message>
        <source>lower arm</source>
        <translation>brazo inferior</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>flip</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>no flip</translation>
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
        <translation>redundante delante</translation>
    </message>
    <message>
        <source>redundant back</source>
        <translation>redundante detrás</translation>
    </message>
    <message>
        <source>previous step&apos;s form</source>
        <translation>forma del paso anterior</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>esta forma</translation>
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
        <translation>pulso</translation>
    </message>
    <message>
        <source>base frame</source>
        <translation>sistema de coordenadas base</translation>
    </message>
    <message>
        <source>robot frame</source>
        <translation>sistema de coordenadas del robot</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>sistema de coordenadas de usuario</translation>
    </message>
    <message>
        <source>tool frame</source>
        <translation>sistema de coordenadas de herramienta</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>grupo %1</translation>
    </message>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>… (%n carácter más)</numerusform>
            <numerusform>… (%n caracteres más)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message>
        <source>Line %1: a cell begins with a quotation mark and does not end with one.</source>
        <translation>Línea %1: una celda empieza con comillas y no termina con ellas.</translation>
    </message>
    <message>
        <source>Line %1: there is text behind the quotation mark that ends a cell.</source>
        <translation>Línea %1: hay texto después de las comillas que cierran una celda.</translation>
    </message>
    <message>
        <source>The file is not UTF-8: save it as “CSV UTF-8” and try again.</source>
        <translation>El archivo no es UTF-8: guárdelo como “CSV UTF-8” e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1” no es un número.</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from %2 to %3.</source>
        <translation>%1 está fuera de rango: debe ser de %2 a %3.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number: write it without decimals and separators.</source>
        <translation>“%1” no es un número entero: escríbalo sin decimales ni separadores.</translation>
    </message>
    <message>
        <source>%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.</source>
        <translation>%1 no cabe en un real: es 0, o de ±1.18e-38 a ±3.40e+38.</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>no es un número</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>“%1” no es un número entero.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>“%1” es demasiado fino: se conserva %n decimal.</numerusform>
            <numerusform>“%1” es demasiado fino: se conservan %n decimales.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is not a variable. Write its letter and its number, such as B007.</source>
        <translation>“%1” no es una variable. Escriba su letra y su número, por ejemplo B007.</translation>
    </message>
    <message>
        <source>There is no %1: this controller has %2 to %3.</source>
        <translation>No existe %1: este controlador tiene de %2 a %3.</translation>
    </message>
    <message>
        <source>“%1” is not a range: it must go from a lower to a higher number of one kind.</source>
        <translation>“%1” no es un rango: debe ir de un número menor a uno mayor de la misma clase.</translation>
    </message>
    <message>
        <source>“%1” is not a type that %2 has.</source>
        <translation>“%1” no es un tipo que tenga %2.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>column: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing, and no value of this type was read.</source>
        <translation>Falta %1, y no se leyó ningún valor de este tipo.</translation>
    </message>
    <message>
        <source>The type is missing, and none was read.</source>
        <translation>Falta el tipo, y no se leyó ninguno.</translation>
    </message>
    <message>
        <source>The variable is missing.</source>
        <translation>Falta la variable.</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1 solo se puede leer.</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already.</source>
        <translation>%1 ya está en la línea %2.</translation>
    </message>
    <message>
        <source>The value is missing.</source>
        <translation>Falta el valor.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>variable: reason</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The column “%1” stands there twice.</source>
        <translation>La columna “%1” aparece dos veces.</translation>
    </message>
    <message>
        <source>The header is missing: the first line must name the columns “variable” and “value”.</source>
        <translation>Falta el encabezado: la primera línea debe nombrar las columnas “variable” y “value”.</translation>
    </message>
    <message>
        <source>There is neither a column “value” nor “axis 1”.</source>
        <translation>No hay ninguna columna “value” ni “axis 1”.</translation>
    </message>
    <message>
        <source>The line has more cells than the header.</source>
        <translation>La línea tiene más celdas que el encabezado.</translation>
    </message>
    <message>
        <source>A block without a header has one or two columns.</source>
        <translation>Un bloque sin encabezado tiene una o dos columnas.</translation>
    </message>
    <message>
        <source>The text cannot be sent: %1.</source>
        <translation>El texto no se puede enviar: %1.</translation>
    </message>
    <message>
        <source>The text must not hold the character NUL, which ends it.</source>
        <translation>El texto no debe contener el carácter NUL, que lo termina.</translation>
    </message>
    <message>
        <source>The text takes %1 bytes; there is room for %2.</source>
        <translation>El texto ocupa %1 bytes; hay espacio para %2.</translation>
    </message>
    <message>
        <source>A position is not written as one text.</source>
        <translation>Una posición no se escribe como un solo texto.</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>un número real</translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>hasta %n byte</numerusform>
            <numerusform>hasta %n bytes</numerusform>
        </translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>pulso</translation>
    </message>
</context>
<context>
    <name>widgets::ArmControl</name>
    <message>
        <source>Hold for 1 s to arm</source>
        <translation>Mantenga pulsado 1 s para armar</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>¿Por qué no?</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Desarmar</translation>
    </message>
    <message>
        <source>Nobody is inside the fence</source>
        <translation>No hay nadie dentro del vallado</translation>
    </message>
    <message>
        <source>I see the robot, or somebody who does</source>
        <translation>Veo el robot, o a alguien que lo ve</translation>
    </message>
    <message>
        <source>An emergency stop is within reach there</source>
        <translation>Allí hay una parada de emergencia al alcance</translation>
    </message>
    <message>
        <source>Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.</source>
        <translation>Armado: son posibles el inicio, Servo ON y los movimientos. Se desarma tras un minuto sin teclado ni ratón.</translation>
    </message>
    <message>
        <source>Disarmed at %1: %2.</source>
        <translation>Desarmado a las %1: %2.</translation>
    </message>
    <message>
        <source>Tick all three first.</source>
        <translation>Marque primero las tres casillas.</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Condiciones</translation>
    </message>
</context>
<context>
    <name>widgets::CellEditor</name>
    <message>
        <source>live: %1</source>
        <translation>en vivo: %1</translation>
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
        <translation>Líneas de ambas versiones</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>Más antigua</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>Más reciente</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::GoToEdit</name>
    <message>
        <source>Go to</source>
        <translation>Ir a</translation>
    </message>
    <message>
        <source>Go to…  Ctrl+G</source>
        <translation>Ir a…  Ctrl+G</translation>
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
        <translation>HOLD (software)</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>retención por software · tecla Pausa</translation>
    </message>
</context>
<context>
    <name>widgets::JobView</name>
    <message>
        <source>Job text</source>
        <translation>Texto del trabajo</translation>
    </message>
</context>
<context>
    <name>widgets::JogPad</name>
    <message>
        <source>Jog %1 forward</source>
        <translation>Mover %1 manualmente hacia delante</translation>
    </message>
    <message>
        <source>Jog %1 back</source>
        <translation>Mover %1 manualmente hacia atrás</translation>
    </message>
</context>
<context>
    <name>widgets::LogicStrip</name>
    <message>
        <source>The watched signals over the last minute</source>
        <translation>Las señales vigiladas durante el último minuto</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
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
        <translation>Cerrar este mensaje</translation>
    </message>
</context>
<context>
    <name>widgets::OrderButton</name>
    <message>
        <source>Why not?</source>
        <translation>¿Por qué no?</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Condiciones</translation>
    </message>
    <message>
        <source>Conditions of: %1</source>
        <translation>Condiciones de: %1</translation>
    </message>
    <message>
        <source>Pending…</source>
        <translation>Pendiente…</translation>
    </message>
</context>
<context>
    <name>widgets::Plot</name>
    <message>
        <source>seconds</source>
        <translation>segundos</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>Nothing is plotted.</source>
        <translation>No hay ninguna curva.</translation>
    </message>
</context>
<context>
    <name>widgets::Plottables</name>
    <message>
        <source>Add to trend: %1</source>
        <translation>Añadir a la tendencia: %1</translation>
    </message>
</context>
<context>
    <name>widgets::Question</name>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
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
        <translation>Tiempos de ida y vuelta de los últimos 60 segundos: aún ninguno.</translation>
    </message>
    <message>
        <source>Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.</source>
        <translation>Tiempos de ida y vuelta de los últimos 60 segundos: el más largo %1 ms, intentos perdidos en %2 s.</translation>
    </message>
</context>
<context>
    <name>widgets::ToolPathView</name>
    <message>
        <source>Top</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frontal</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lateral</translation>
    </message>
    <message>
        <source>Tool path, %1 view</source>
        <translation>Trayectoria de herramienta, vista %1</translation>
    </message>
    <message>
        <source>No position in the base frame was read yet.</source>
        <translation>Aún no se ha leído ninguna posición en el sistema de coordenadas base.</translation>
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
