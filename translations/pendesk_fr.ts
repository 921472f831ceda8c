<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>Actions</name>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (logiciel)</translation>
    </message>
    <message>
        <source>Access level…</source>
        <translation>Niveau d’accès…</translation>
    </message>
    <message>
        <source>Open this page in its own window</source>
        <translation>Ouvrir cette page dans sa propre fenêtre</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Connecter…</translation>
    </message>
    <message>
        <source>Connect to this controller</source>
        <translation>Se connecter à ce contrôleur</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Ouvrir la démo</translation>
    </message>
    <message>
        <source>Diagnose…</source>
        <translation>Diagnostiquer…</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>Copier le diagnostic</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>À propos de Pendesk</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Language and look…</source>
        <translation>Langue et apparence…</translation>
    </message>
    <message>
        <source>Readiness…</source>
        <translation>Disponibilité…</translation>
    </message>
    <message>
        <source>Help and shortcuts</source>
        <translation>Aide et raccourcis</translation>
    </message>
</context>
<context>
    <name>Alarms</name>
    <message>
        <source>Major</source>
        <translation>Majeure</translation>
    </message>
    <message>
        <source>Minor</source>
        <translation>Mineure</translation>
    </message>
    <message>
        <source>User, system</source>
        <translation>Utilisateur, système</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>Off-line</source>
        <translation>Hors ligne</translation>
    </message>
    <message>
        <source>◆ unacknowledged</source>
        <translation>◆ non acquittée</translation>
    </message>
    <message>
        <source>■ acknowledged</source>
        <translation>■ acquittée</translation>
    </message>
    <message>
        <source>▲ cleared, unacknowledged</source>
        <translation>▲ disparue, non acquittée</translation>
    </message>
    <message>
        <source>□ cleared</source>
        <translation>□ disparue</translation>
    </message>
    <message>
        <source>No sub code.</source>
        <translation>Pas de sous-code.</translation>
    </message>
    <message>
        <source>%1: %2. As sent: %3, type %4.</source>
        <translation>%1&#xa0;: %2. Tel que reçu&#xa0;: %3, type %4.</translation>
    </message>
</context>
<context>
    <name>Conditions</name>
    <message>
        <source>%1: %2.</source>
        <comment>what is wrong: what helps</comment>
        <translation>%1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>met</source>
        <translation>remplie</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>non remplie</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>pas encore lu</translation>
    </message>
    <message>
        <source>cannot be read over HSES</source>
        <translation>illisible par HSES</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>what was tried: how it ended</comment>
        <translation>%1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>Reset alarm</source>
        <translation>Réinitialiser l’alarme</translation>
    </message>
    <message>
        <source>Cancel error</source>
        <translation>Effacer l’erreur</translation>
    </message>
    <message>
        <source>Write a signal</source>
        <translation>Écrire un signal</translation>
    </message>
    <message>
        <source>Write a register</source>
        <translation>Écrire un registre</translation>
    </message>
    <message>
        <source>Write a variable</source>
        <translation>Écrire une variable</translation>
    </message>
    <message>
        <source>Select a job</source>
        <translation>Sélectionner un job</translation>
    </message>
    <message>
        <source>Select a master job</source>
        <translation>Sélectionner un job maître</translation>
    </message>
    <message>
        <source>Start the job</source>
        <translation>Démarrer le job</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (logiciel)</translation>
    </message>
    <message>
        <source>Release HOLD</source>
        <translation>Annuler HOLD</translation>
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
        <translation>Sélectionner le mode de cycle</translation>
    </message>
    <message>
        <source>Show a message on the pendant</source>
        <translation>Afficher un message sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Déplacement manuel</translation>
    </message>
    <message>
        <source>Send a file to the controller</source>
        <translation>Envoyer un fichier au contrôleur</translation>
    </message>
    <message>
        <source>Get a file from the controller</source>
        <translation>Récupérer un fichier du contrôleur</translation>
    </message>
    <message>
        <source>Delete a file on the controller</source>
        <translation>Supprimer un fichier du contrôleur</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Restaurer une sauvegarde</translation>
    </message>
    <message>
        <source>Monitor</source>
        <translation>Surveillance</translation>
    </message>
    <message>
        <source>Operate</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Ingénierie</translation>
    </message>
    <message>
        <source>disarmed by hand</source>
        <translation>désarmé manuellement</translation>
    </message>
    <message>
        <source>nobody used key or mouse for a minute</source>
        <translation>ni clavier ni souris utilisés pendant une minute</translation>
    </message>
    <message>
        <source>another program came to the front</source>
        <translation>un autre programme est passé au premier plan</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>l’écran a été verrouillé</translation>
    </message>
    <message>
        <source>communication was lost</source>
        <translation>la communication a été perdue</translation>
    </message>
    <message>
        <source>the mode changed at the controller</source>
        <translation>le mode a changé sur le contrôleur</translation>
    </message>
    <message>
        <source>an alarm came up</source>
        <translation>une alarme est apparue</translation>
    </message>
    <message>
        <source>the access level fell back</source>
        <translation>le niveau d’accès est redescendu</translation>
    </message>
    <message>
        <source>another window came to the front</source>
        <translation>une autre fenêtre est passée au premier plan</translation>
    </message>
    <message>
        <source>another controller was armed</source>
        <translation>un autre contrôleur a été armé</translation>
    </message>
    <message>
        <source>The link to the controller is up</source>
        <translation>La liaison avec le contrôleur est établie</translation>
    </message>
    <message>
        <source>The access level is Operate or Engineer</source>
        <translation>Le niveau d’accès est Opération ou Ingénierie</translation>
    </message>
    <message>
        <source>The access level is Engineer</source>
        <translation>Le niveau d’accès est Ingénierie</translation>
    </message>
    <message>
        <source>The status is fresh</source>
        <translation>L’état est à jour</translation>
    </message>
    <message>
        <source>This controller is armed</source>
        <translation>Ce contrôleur est armé</translation>
    </message>
    <message>
        <source>REMOTE is on</source>
        <translation>REMOTE est activé</translation>
    </message>
    <message>
        <source>The mode is PLAY</source>
        <translation>Le mode est PLAY</translation>
    </message>
    <message>
        <source>The mode is not TEACH</source>
        <translation>Le mode n’est pas TEACH</translation>
    </message>
    <message>
        <source>There is no alarm</source>
        <translation>Il n’y a pas d’alarme</translation>
    </message>
    <message>
        <source>There is no error</source>
        <translation>Il n’y a pas d’erreur</translation>
    </message>
    <message>
        <source>Not held by the pendant</source>
        <translation>Pas de HOLD par le boîtier de programmation</translation>
    </message>
    <message>
        <source>Not held by an external signal</source>
        <translation>Pas de HOLD par un signal externe</translation>
    </message>
    <message>
        <source>Not held by a command</source>
        <translation>Pas de HOLD par une commande</translation>
    </message>
    <message>
        <source>Held by a command</source>
        <translation>HOLD par une commande</translation>
    </message>
    <message>
        <source>Servo power is on</source>
        <translation>L’alimentation servo est activée</translation>
    </message>
    <message>
        <source>No job is running</source>
        <translation>Aucun job n’est en marche</translation>
    </message>
    <message>
        <source>A job is selected</source>
        <translation>Un job est sélectionné</translation>
    </message>
    <message>
        <source>The numbering of variables is verified</source>
        <translation>La numérotation des variables est vérifiée</translation>
    </message>
    <message>
        <source>The model takes move orders</source>
        <translation>Le modèle accepte les ordres de déplacement</translation>
    </message>
    <message>
        <source>The safety circuit is closed</source>
        <translation>Le circuit de sécurité est fermé</translation>
    </message>
    <message>
        <source>Not held by a playback panel</source>
        <translation>Pas de HOLD par un panneau de lecture (playback)</translation>
    </message>
    <message>
        <source>Home position and position check are confirmed</source>
        <translation>La position d’origine et le contrôle de position sont confirmés</translation>
    </message>
    <message>
        <source>Starting is not locked at the panel</source>
        <translation>Le démarrage n’est pas verrouillé sur le panneau</translation>
    </message>
    <message>
        <source>Mode and cycle are not locked at the panel</source>
        <translation>Le mode et le cycle ne sont pas verrouillés sur le panneau</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is permitted</source>
        <translation>La sélection d’un job en REMOTE et PLAY est autorisée</translation>
    </message>
    <message>
        <source>Changing the master job is permitted</source>
        <translation>Le changement du job maître est autorisé</translation>
    </message>
    <message>
        <source>The job exists on the controller</source>
        <translation>Le job existe sur le contrôleur</translation>
    </message>
    <message>
        <source>Nothing is being edited at the pendant</source>
        <translation>Aucune édition n’est en cours sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>No other function uses the files</source>
        <translation>Aucune autre fonction n’utilise les fichiers</translation>
    </message>
    <message>
        <source>The data are not protected</source>
        <translation>Les données ne sont pas protégées</translation>
    </message>
    <message>
        <source>Replacing existing files is permitted</source>
        <translation>Le remplacement de fichiers existants est autorisé</translation>
    </message>
    <message>
        <source>There is no link to the controller</source>
        <translation>Il n’y a pas de liaison avec le contrôleur</translation>
    </message>
    <message>
        <source>connect, or wait until it answers again</source>
        <translation>se connecter, ou attendre qu’il réponde à nouveau</translation>
    </message>
    <message>
        <source>The access level is Monitor</source>
        <translation>Le niveau d’accès est Surveillance</translation>
    </message>
    <message>
        <source>switch to Operate in the strip (Ctrl+L)</source>
        <translation>passer à Opération dans le bandeau (Ctrl+L)</translation>
    </message>
    <message>
        <source>The access level is not Engineer</source>
        <translation>Le niveau d’accès n’est pas Ingénierie</translation>
    </message>
    <message>
        <source>switch to Engineer in the strip (Ctrl+L)</source>
        <translation>passer à Ingénierie dans le bandeau (Ctrl+L)</translation>
    </message>
    <message>
        <source>The status was not read just now</source>
        <translation>L’état n’a pas été lu récemment</translation>
    </message>
    <message>
        <source>wait a moment; if it stays so, look at the link</source>
        <translation>attendre un instant&#xa0;; si cela persiste, vérifier la liaison</translation>
    </message>
    <message>
        <source>This controller is not armed</source>
        <translation>Ce contrôleur n’est pas armé</translation>
    </message>
    <message>
        <source>arm it on this page</source>
        <translation>l’armer sur cette page</translation>
    </message>
    <message>
        <source>REMOTE is off</source>
        <translation>REMOTE est désactivé</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and switch on CMD REMOTE SEL: %1</source>
        <translation>tourner la clé du boîtier de programmation sur REMOTE et activer CMD REMOTE SEL&#xa0;: %1</translation>
    </message>
    <message>
        <source>The mode is not PLAY</source>
        <translation>Le mode n’est pas PLAY</translation>
    </message>
    <message>
        <source>turn the pendant key to PLAY or REMOTE</source>
        <translation>tourner la clé du boîtier de programmation sur PLAY ou REMOTE</translation>
    </message>
    <message>
        <source>The controller is in TEACH</source>
        <translation>Le contrôleur est en TEACH</translation>
    </message>
    <message>
        <source>the person at the pendant has the robot: turn the key to REMOTE when that is over</source>
        <translation>la personne au boîtier de programmation a le contrôle du robot&#xa0;: tourner la clé sur REMOTE quand elle a terminé</translation>
    </message>
    <message>
        <source>There is an alarm</source>
        <translation>Il y a une alarme</translation>
    </message>
    <message>
        <source>remove its cause, then reset it on the Alarms page</source>
        <translation>en éliminer la cause, puis la réinitialiser sur la page Alarmes</translation>
    </message>
    <message>
        <source>There is an error</source>
        <translation>Il y a une erreur</translation>
    </message>
    <message>
        <source>read it on the Alarms page, then cancel it</source>
        <translation>la lire sur la page Alarmes, puis l’effacer</translation>
    </message>
    <message>
        <source>Held by the pendant</source>
        <translation>HOLD par le boîtier de programmation</translation>
    </message>
    <message>
        <source>release it there</source>
        <translation>annuler HOLD à cet endroit</translation>
    </message>
    <message>
        <source>Held by an external signal</source>
        <translation>HOLD par un signal externe</translation>
    </message>
    <message>
        <source>release it where that signal comes from</source>
        <translation>annuler HOLD là d’où vient ce signal</translation>
    </message>
    <message>
        <source>release HOLD on the Jobs page</source>
        <translation>annuler HOLD sur la page Jobs</translation>
    </message>
    <message>
        <source>No command holds the robot</source>
        <translation>Aucune commande ne maintient le robot en HOLD</translation>
    </message>
    <message>
        <source>there is nothing to release from here</source>
        <translation>il n’y a rien à annuler d’ici</translation>
    </message>
    <message>
        <source>Servo power is off</source>
        <translation>L’alimentation servo est coupée</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>activer le servo</translation>
    </message>
    <message>
        <source>A job is running</source>
        <translation>Un job est en marche</translation>
    </message>
    <message>
        <source>wait until it has ended, or hold it</source>
        <translation>attendre qu’il soit terminé, ou l’arrêter par HOLD</translation>
    </message>
    <message>
        <source>No job is selected</source>
        <translation>Aucun job n’est sélectionné</translation>
    </message>
    <message>
        <source>select one on the Jobs page</source>
        <translation>en sélectionner un sur la page Jobs</translation>
    </message>
    <message>
        <source>The numbering of variables is not verified</source>
        <translation>La numérotation des variables n’est pas vérifiée</translation>
    </message>
    <message>
        <source>compare two variables with the pendant (Variables page)</source>
        <translation>comparer deux variables avec le boîtier de programmation (page Variables)</translation>
    </message>
    <message>
        <source>This model takes no move orders</source>
        <translation>Ce modèle n’accepte pas d’ordres de déplacement</translation>
    </message>
    <message>
        <source>move it with the pendant</source>
        <translation>déplacer le robot avec le boîtier de programmation</translation>
    </message>
    <message>
        <source>The safety circuit is open</source>
        <translation>Le circuit de sécurité est ouvert</translation>
    </message>
    <message>
        <source>look at emergency stops, doors and the enabling switch</source>
        <translation>vérifier les arrêts d’urgence, les portes et l’interrupteur de validation</translation>
    </message>
    <message>
        <source>Held by a playback panel</source>
        <translation>HOLD par un panneau de lecture (playback)</translation>
    </message>
    <message>
        <source>Home position or position check is missing</source>
        <translation>La position d’origine ou le contrôle de position manque</translation>
    </message>
    <message>
        <source>confirm the position at the pendant</source>
        <translation>confirmer la position sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>Starting is locked at the panel</source>
        <translation>Le démarrage est verrouillé sur le panneau</translation>
    </message>
    <message>
        <source>release the start lock (I/O or panel prohibit) at the cell</source>
        <translation>annuler le verrouillage du démarrage (E/S ou interdiction au panneau) sur la cellule</translation>
    </message>
    <message>
        <source>Mode and cycle are locked at the panel</source>
        <translation>Le mode et le cycle sont verrouillés sur le panneau</translation>
    </message>
    <message>
        <source>release the panel lock (I/O or panel prohibit) at the cell</source>
        <translation>annuler le verrouillage du panneau (E/S ou interdiction au panneau) sur la cellule</translation>
    </message>
    <message>
        <source>Selecting a job in REMOTE and PLAY is prohibited</source>
        <translation>La sélection d’un job en REMOTE et PLAY est interdite</translation>
    </message>
    <message>
        <source>set “job select when remote and play” to permit: %1</source>
        <translation>mettre «&#xa0;job select when remote and play&#xa0;» sur «&#xa0;permit&#xa0;»&#xa0;: %1</translation>
    </message>
    <message>
        <source>Changing the master job is prohibited</source>
        <translation>Le changement du job maître est interdit</translation>
    </message>
    <message>
        <source>permit it at the pendant (master call, teach lock): %1</source>
        <translation>l’autoriser sur le boîtier de programmation (appel du job maître, verrouillage d’apprentissage)&#xa0;: %1</translation>
    </message>
    <message>
        <source>The job is not on the controller</source>
        <translation>Le job n’est pas sur le contrôleur</translation>
    </message>
    <message>
        <source>read the list of jobs again</source>
        <translation>relire la liste des jobs</translation>
    </message>
    <message>
        <source>Something is being edited at the pendant</source>
        <translation>Une édition est en cours sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>leave the editor there</source>
        <translation>y quitter l’éditeur</translation>
    </message>
    <message>
        <source>Another function uses the files</source>
        <translation>Une autre fonction utilise les fichiers</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>réessayer dans un instant</translation>
    </message>
    <message>
        <source>The data are protected</source>
        <translation>Les données sont protégées</translation>
    </message>
    <message>
        <source>release the protection at the pendant</source>
        <translation>annuler la protection sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>Replacing files is not permitted</source>
        <translation>Le remplacement de fichiers n’est pas autorisé</translation>
    </message>
    <message>
        <source>set the parameters RS029 and RS214 to 1: %1</source>
        <translation>mettre les paramètres RS029 et RS214 à 1&#xa0;: %1</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION COND. ou FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE</source>
        <translation>SETUP, FUNCTION ENABLE</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION COND. or TEACHING COND.</source>
        <translation>SETUP, FUNCTION COND. ou TEACHING COND.</translation>
    </message>
    <message>
        <source>SETUP, FUNCTION ENABLE or TEACHING COND.</source>
        <translation>SETUP, FUNCTION ENABLE ou TEACHING COND.</translation>
    </message>
    <message>
        <source>PARAMETER, RS (management mode)</source>
        <translation>PARAMETER, RS (mode de gestion)</translation>
    </message>
    <message>
        <source>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 on a DX100)</source>
        <translation>IN/OUT, PSEUDO INPUT SIG, CMD REMOTE SEL (#82015 sur un DX100)</translation>
    </message>
    <message>
        <source>The controller shows an error</source>
        <translation>Le contrôleur affiche une erreur</translation>
    </message>
    <message>
        <source>The controller shows no error</source>
        <translation>Le contrôleur n’affiche aucune erreur</translation>
    </message>
    <message>
        <source>there is nothing to cancel</source>
        <translation>il n’y a rien à effacer</translation>
    </message>
    <message>
        <source>the connection was closed</source>
        <translation>la connexion a été fermée</translation>
    </message>
    <message>
        <source>the language was changed</source>
        <translation>la langue a été changée</translation>
    </message>
    <message>
        <source>the window was turned to another controller</source>
        <translation>la fenêtre est passée à un autre contrôleur</translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation>l’ordinateur s’est mis en veille</translation>
    </message>
    <message>
        <source>this program stood still, or the computer&apos;s clock jumped</source>
        <translation>ce programme s’est figé, ou l’horloge de l’ordinateur a sauté</translation>
    </message>
</context>
<context>
    <name>FileSheet</name>
    <message>
        <source>There is no “%1”.</source>
        <translation>«&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>There is no folder “%1”.</source>
        <translation>Le dossier «&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>“%1” exists already. Is it to be replaced?</source>
        <translation>«&#xa0;%1&#xa0;» existe déjà. Faut-il le remplacer&#xa0;?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
</context>
<context>
    <name>LinkView</name>
    <message>
        <source>checking</source>
        <translation>vérification</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en direct</translation>
    </message>
    <message>
        <source>communication lost</source>
        <translation>communication perdue</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Diagnose…</source>
        <translation>Diagnostiquer…</translation>
    </message>
    <message>
        <source>HOLD not confirmed: use the pendant.</source>
        <translation>HOLD non confirmé&#xa0;: utiliser le boîtier de programmation.</translation>
    </message>
    <message>
        <source>HOLD was refused: %1. Use the pendant.</source>
        <translation>HOLD a été refusé&#xa0;: %1. Utiliser le boîtier de programmation.</translation>
    </message>
    <message>
        <source>No contact with %1 yet: %2. Checking goes on by itself.</source>
        <translation>Pas encore de contact avec %1&#xa0;: %2. La vérification continue automatiquement.</translation>
    </message>
    <message>
        <source>Checking %1: waiting for system information and status.</source>
        <translation>Vérification de %1&#xa0;: attente des informations système et de l’état.</translation>
    </message>
    <message>
        <source>Communication lost at %1 — showing the last values read. Reading resumes by itself.</source>
        <translation>Communication perdue à %1 — les dernières valeurs lues sont affichées. La lecture reprend automatiquement.</translation>
    </message>
    <message numerus="yes">
        <source>Communication restored at %1. Lost %n time(s) since connecting.</source>
        <translation>
            <numerusform>Communication rétablie à %1. Perdue %n fois depuis la connexion.</numerusform>
            <numerusform>Communication rétablie à %1. Perdue %n fois depuis la connexion.</numerusform>
        </translation>
    </message>
    <message>
        <source>HOLD was not sent: there is no connection to a controller. Use the pendant.</source>
        <translation>HOLD n’a pas été envoyé&#xa0;: il n’y a pas de connexion à un contrôleur. Utiliser le boîtier de programmation.</translation>
    </message>
    <message>
        <source>Connect…</source>
        <translation>Connecter…</translation>
    </message>
</context>
<context>
    <name>Noise</name>
    <message>
        <source>Date of the last change of a job (///DATE)</source>
        <translation>Date de la dernière modification d’un job (///DATE)</translation>
    </message>
    <message>
        <source>Dates and times of day, such as 2026/01/31 08:30</source>
        <translation>Dates et heures, par exemple 2026/01/31 08:30</translation>
    </message>
    <message>
        <source>Operating time counters, such as 18:19&apos;02</source>
        <translation>Compteurs de temps de fonctionnement, par exemple 18:19&apos;02</translation>
    </message>
    <message>
        <source>Blanks at the end of a line</source>
        <translation>Espaces en fin de ligne</translation>
    </message>
    <message>
        <source>Line ends: CR LF or LF, and whether the last line has one</source>
        <translation>Fins de ligne&#xa0;: CR LF ou LF, et présence ou non d’une fin à la dernière ligne</translation>
    </message>
</context>
<context>
    <name>OrderRecords</name>
    <message>
        <source>✓ done</source>
        <translation>✓ exécuté</translation>
    </message>
    <message>
        <source>✗ refused</source>
        <translation>✗ refusé</translation>
    </message>
    <message>
        <source>▲ unknown</source>
        <translation>▲ inconnu</translation>
    </message>
    <message>
        <source>□ not sent</source>
        <translation>□ non envoyé</translation>
    </message>
    <message>
        <source>□ cancelled</source>
        <translation>□ annulé</translation>
    </message>
</context>
<context>
    <name>Page</name>
    <message>
        <source>kept on this computer</source>
        <translation>conservé sur cet ordinateur</translation>
    </message>
    <message>
        <source>the last values read before %1</source>
        <translation>les dernières valeurs lues avant %1</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Overview</source>
        <translation>Vue d’ensemble</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>I/O</source>
        <translation>E/S</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Registres</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>Déplacement manuel et mouvement</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Tendance</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Jobs</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Sauvegarde</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>The state of the robot at a glance: mode, cycle, servo, run, the three causes of a hold, alarm, error and speed limit, the executing job, the position of R1, and how well the link works.</source>
        <translation>L’état du robot en un coup d’œil&#xa0;: mode, cycle, servo, marche, les trois causes d’un HOLD, alarme, erreur et limite de vitesse, le job en exécution, la position de R1 et la qualité de la liaison.</translation>
    </message>
    <message>
        <source>“What can I do now?” lists what may be ordered. ✓ may be tried, ✗ may not, with the first reason beside it.</source>
        <translation>«&#xa0;Que puis-je faire maintenant&#xa0;?&#xa0;» liste les ordres possibles. ✓ peut être essayé, ✗ ne le peut pas, avec le premier motif à côté.</translation>
    </message>
    <message>
        <source>Bits that contradict each other, such as TEACH and PLAY, are shown side by side as they were received, under ▲.</source>
        <translation>Les bits contradictoires, tels que TEACH et PLAY, sont affichés côte à côte tels que reçus, sous ▲.</translation>
    </message>
    <message>
        <source>Copy beside the system information takes model and software to the clipboard. The right mouse button on a number adds it to the trend.</source>
        <translation>«&#xa0;Copier&#xa0;», à côté des informations système, place le modèle et le logiciel dans le presse-papiers. Un clic droit sur un nombre permet de l’ajouter à la tendance.</translation>
    </message>
    <message>
        <source>Up to four active alarms, the newest first, and the past alarms that were read from the controller.</source>
        <translation>Jusqu’à quatre alarmes actives, la plus récente en premier, et les alarmes passées lues sur le contrôleur.</translation>
    </message>
    <message>
        <source>Acknowledge is noted on this computer only: the robot does not hear of it.</source>
        <translation>«&#xa0;Acquitter&#xa0;» n’est noté que sur cet ordinateur&#xa0;: le robot n’en est pas informé.</translation>
    </message>
    <message>
        <source>Reset alarm and Cancel error are orders: they need REMOTE and the level Operate, and say before what they clear. After a reset that was accepted an alarm may stay: then its cause is still there.</source>
        <translation>«&#xa0;Réinitialiser l’alarme&#xa0;» et «&#xa0;Effacer l’erreur&#xa0;» sont des ordres&#xa0;: ils exigent REMOTE et le niveau Opération, et indiquent d’avance ce qu’ils effacent. Après une réinitialisation acceptée, une alarme peut subsister&#xa0;: sa cause est alors encore présente.</translation>
    </message>
    <message>
        <source>Read now fetches the history and keeps it in the journal, even after the controller has dropped it. Most frequent counts codes.</source>
        <translation>«&#xa0;Lire maintenant&#xa0;» récupère l’historique et le conserve dans le journal, même une fois que le contrôleur l’a effacé. «&#xa0;Plus fréquentes&#xa0;» compte les codes.</translation>
    </message>
    <message>
        <source>Notes keep what caused a code and what was done, on this computer.</source>
        <translation>Les notes conservent sur cet ordinateur la cause d’un code et ce qui a été fait.</translation>
    </message>
    <message>
        <source>All signals of one area, a group of eight in a row. A filled square is 1, a hollow one 0; a frame marks what changed in the last two seconds.</source>
        <translation>Tous les signaux d’une zone, un groupe de huit par ligne. Un carré plein vaut 1, un carré vide 0&#xa0;; un cadre marque ce qui a changé dans les deux dernières secondes.</translation>
    </message>
    <message>
        <source>Only network inputs can be written over HSES, by an engineer. A write reads the group, changes one bit, shows old and new, and reads back: eight bits travel together.</source>
        <translation>Par HSES, seules les entrées réseau peuvent être écrites, au niveau Ingénierie. Une écriture lit le groupe, modifie un bit, affiche l’ancien et le nouveau, puis relit&#xa0;: huit bits sont transmis ensemble.</translation>
    </message>
    <message>
        <source>Names come from the controller&apos;s IONAME.DAT. The right mouse button names a signal here, or puts it on the tab Watch.</source>
        <translation>Les noms viennent du fichier IONAME.DAT du contrôleur. Un clic droit permet de nommer un signal ici ou de le placer dans l’onglet «&#xa0;Suivre&#xa0;».</translation>
    </message>
    <message>
        <source>Watch counts edges and draws the last minute. It reads four times a second: shorter pulses are not seen.</source>
        <translation>«&#xa0;Suivre&#xa0;» compte les fronts et trace la dernière minute. La lecture a lieu quatre fois par seconde&#xa0;: les impulsions plus courtes ne sont pas vues.</translation>
    </message>
    <message>
        <source>Go to takes #27010 as well as IN#(1).</source>
        <translation>«&#xa0;Aller à&#xa0;» accepte #27010 aussi bien que IN#(1).</translation>
    </message>
    <message>
        <source>The registers M000 to M999, as decimal, signed, hexadecimal or binary numbers. Only the rows in view are read.</source>
        <translation>Les registres M000 à M999, en nombres décimaux, signés, hexadécimaux ou binaires. Seules les lignes affichées sont lues.</translation>
    </message>
    <message>
        <source>M000 to M559 can be written by an engineer; the others belong to the ladder.</source>
        <translation>M000 à M559 peuvent être écrits au niveau Ingénierie&#xa0;; les autres appartiennent au programme ladder.</translation>
    </message>
    <message>
        <source>Enter in the editor stages a value: it turns amber and nothing is sent. Apply shows old and new of all staged values, writes each once, and reads it back.</source>
        <translation>Dans l’éditeur, Entrée prépare une valeur&#xa0;: elle passe à l’ambre et rien n’est envoyé. «&#xa0;Appliquer&#xa0;» affiche l’ancienne et la nouvelle valeur de toutes les valeurs préparées, écrit chacune une fois et la relit.</translation>
    </message>
    <message>
        <source>A value that reads back differently is red and stays. Undo last stages the values from before the last Apply.</source>
        <translation>Une valeur dont la relecture diffère est en rouge et reste affichée. «&#xa0;Annuler le dernier&#xa0;» prépare les valeurs d’avant le dernier «&#xa0;Appliquer&#xa0;».</translation>
    </message>
    <message>
        <source>The variables B I D R S P BP and EX with their names, their value before, and when they changed. Only the rows in view are read.</source>
        <translation>Les variables B I D R S P BP et EX avec leurs noms, leur valeur précédente et le moment de leur modification. Seules les lignes affichées sont lues.</translation>
    </message>
    <message>
        <source>Nothing is written before the numbering was compared with the pendant: Verify… does that, and only reads.</source>
        <translation>Rien n’est écrit avant que la numérotation ait été comparée avec le boîtier de programmation&#xa0;: «&#xa0;Vérifier…&#xa0;» le fait et ne fait que lire.</translation>
    </message>
    <message>
        <source>Import and Export take CSV files; cells of a spreadsheet can be pasted. Both show first what would differ.</source>
        <translation>«&#xa0;Importer…&#xa0;» et «&#xa0;Exporter…&#xa0;» utilisent des fichiers CSV&#xa0;; les cellules d’un tableur peuvent être collées. Les deux affichent d’abord ce qui différerait.</translation>
    </message>
    <message>
        <source>A watch page is a list of your own: the right mouse button puts rows of any tab on it.</source>
        <translation>Une page de suivi est une liste personnelle&#xa0;: un clic droit permet d’y placer des lignes de n’importe quel onglet.</translation>
    </message>
    <message>
        <source>The tool point in the base frame, with form and tool; the axes in pulses with following error, torque and temperature where the model tells them; and the path of the tool point.</source>
        <translation>Le point outil dans le repère base, avec configuration et outil&#xa0;; les axes en impulsions, avec erreur de poursuite, couple et température là où le modèle les communique&#xa0;; et la trajectoire du point outil.</translation>
    </message>
    <message>
        <source>Degrees of axes stand here only where the profile gives pulses per degree: the controller does not tell them.</source>
        <translation>Les degrés des axes ne figurent ici que si le profil indique les impulsions par degré&#xa0;: le contrôleur ne les communique pas.</translation>
    </message>
    <message>
        <source>Torque is shown as the controller sends it: its unit is stated nowhere.</source>
        <translation>Le couple est affiché tel que le contrôleur l’envoie&#xa0;: son unité n’est indiquée nulle part.</translation>
    </message>
    <message>
        <source>Min and max count from the last reset, while this page is read. Copy as text takes the table in view.</source>
        <translation>Min. et max. comptent depuis la dernière réinitialisation, tant que cette page est lue. «&#xa0;Copier comme texte&#xa0;» reprend le tableau affiché.</translation>
    </message>
    <message>
        <source>Control groups that the controller refuses have no tab; the line beside the tabs counts them.</source>
        <translation>Les groupes d’axes que le contrôleur refuse n’ont pas d’onglet&#xa0;; la ligne à côté des onglets les compte.</translation>
    </message>
    <message>
        <source>Moves the robot by orders, in automatic operation. The pendant&apos;s enabling switch does not protect anyone here, and nobody may be inside the fence. It is off in TEACH, always.</source>
        <translation>Déplace le robot par des ordres, en fonctionnement automatique. L’interrupteur de validation du boîtier de programmation ne protège personne ici, et personne ne doit se trouver à l’intérieur de l’enceinte de protection. Toujours désactivé en TEACH.</translation>
    </message>
    <message>
        <source>Arming needs the level Operate, REMOTE and PLAY; moving needs Engineer too. Losing the focus, a minute without a key or the mouse, an alarm or a lost link disarms.</source>
        <translation>Armer exige le niveau Opération, REMOTE et PLAY&#xa0;; déplacer exige en plus le niveau Ingénierie. La perte du focus, une minute sans clavier ni souris, une alarme ou une liaison perdue désarme.</translation>
    </message>
    <message>
        <source>Jog sends one bounded step after another while a button is held. Letting go sends no more steps and holds the one that runs; after a lost link the robot still ends its step.</source>
        <translation>«&#xa0;Déplacement manuel&#xa0;» envoie un pas limité après l’autre tant qu’un bouton est maintenu. Relâcher le bouton n’envoie plus de pas et arrête par HOLD celui en cours&#xa0;; après une perte de liaison, le robot termine quand même son pas.</translation>
    </message>
    <message>
        <source>Move shows present place, target and change first. Rehearse… opens the sheet on which the move is confirmed.</source>
        <translation>«&#xa0;Déplacer&#xa0;» affiche d’abord la position actuelle, la cible et la variation. «&#xa0;Contrôle préalable…&#xa0;» ouvre la fenêtre dans laquelle le mouvement est confirmé.</translation>
    </message>
    <message>
        <source>What was sent without an answer is called unknown, never failed: look at the robot.</source>
        <translation>Ce qui a été envoyé sans réponse est dit inconnu, jamais échoué&#xa0;: observer le robot.</translation>
    </message>
    <message>
        <source>Draws any number over time. Drag it here from a page, choose “Add to trend” in its menu, or use Add signal….</source>
        <translation>Trace n’importe quel nombre dans le temps. Le faire glisser ici depuis une page, choisir «&#xa0;Ajouter à la tendance&#xa0;» dans son menu ou utiliser «&#xa0;Ajouter un signal…&#xa0;».</translation>
    </message>
    <message>
        <source>Pause freezes the view; recording goes on. Gaps in a curve are times in which nothing was read.</source>
        <translation>«&#xa0;Pause&#xa0;» fige l’affichage&#xa0;; l’enregistrement continue. Les interruptions d’une courbe sont des moments où rien n’a été lu.</translation>
    </message>
    <message>
        <source>The time box chooses how long a time is in view; under the cursor stand the values of that moment.</source>
        <translation>La liste de durée choisit la durée affichée&#xa0;; sous le curseur figurent les valeurs de cet instant.</translation>
    </message>
    <message>
        <source>An incident keeps 60 s before and 20 s after an alarm came up. It can be opened here later.</source>
        <translation>Un incident conserve 60 s avant et 20 s après l’apparition d’une alarme. Il peut être ouvert ici plus tard.</translation>
    </message>
    <message>
        <source>Export CSV… writes what is in view, with times in UTC.</source>
        <translation>«&#xa0;Exporter en CSV…&#xa0;» écrit ce qui est affiché, avec les heures en UTC.</translation>
    </message>
    <message>
        <source>The jobs on the controller and the text of the chosen one, with the line that is executed. A banner says when the text may be old.</source>
        <translation>Les jobs sur le contrôleur et le texte de celui choisi, avec la ligne en exécution. Une bannière signale quand le texte peut être périmé.</translation>
    </message>
    <message>
        <source>Start needs REMOTE, PLAY, servo on, the level Operate and an armed controller. Its sheet names controller, job and line, and the button works after one second. Nothing is ever started twice.</source>
        <translation>«&#xa0;Démarrer&#xa0;» exige REMOTE, PLAY, Servo ON, le niveau Opération et un contrôleur armé. Sa fenêtre indique contrôleur, job et ligne, et le bouton n’est actif qu’après une seconde. Aucun démarrage n’est jamais envoyé deux fois.</translation>
    </message>
    <message>
        <source>Buttons show what was read. “Pending” stands until the status agrees.</source>
        <translation>Les boutons affichent ce qui a été lu. «&#xa0;En attente&#xa0;» reste affiché jusqu’à ce que l’état concorde.</translation>
    </message>
    <message>
        <source>HOLD from here can be released here. A hold by the pendant is released there.</source>
        <translation>Un HOLD envoyé d’ici peut être annulé ici. Un HOLD par le boîtier de programmation s’annule sur celui-ci.</translation>
    </message>
    <message>
        <source>“Why not?” beside a button lists all its conditions.</source>
        <translation>«&#xa0;Pourquoi pas&#xa0;?&#xa0;» à côté d’un bouton liste toutes ses conditions.</translation>
    </message>
    <message>
        <source>Files of this computer on the left, of the controller on the right, by type.</source>
        <translation>Les fichiers de cet ordinateur à gauche, ceux du contrôleur à droite, par type.</translation>
    </message>
    <message>
        <source>Fetch only reads. Send and Delete are for engineers and need REMOTE on.</source>
        <translation>«&#xa0;Récupérer&#xa0;» ne fait que lire. «&#xa0;Envoyer&#xa0;» et «&#xa0;Supprimer&#xa0;» sont réservés au niveau Ingénierie et exigent que REMOTE soit activé.</translation>
    </message>
    <message>
        <source>A file that exists already is asked about: compare it, replace it, or leave it, which is the default. A file cut off half way never replaces a good one.</source>
        <translation>Si un fichier existe déjà, une question est posée&#xa0;: le comparer, le remplacer ou le laisser tel quel, choix par défaut. Un fichier interrompu en cours de transfert ne remplace jamais un fichier correct.</translation>
    </message>
    <message>
        <source>Before a job is sent its text is checked, and afterwards it is read back and compared.</source>
        <translation>Avant l’envoi d’un job, son texte est vérifié&#xa0;; ensuite, il est relu et comparé.</translation>
    </message>
    <message>
        <source>Transfers lists every file with its bytes and state. Retry failed sends none that was finished.</source>
        <translation>«&#xa0;Transferts&#xa0;» liste chaque fichier avec ses octets et son état. «&#xa0;Relancer les échecs&#xa0;» n’envoie aucun fichier déjà terminé.</translation>
    </message>
    <message>
        <source>Backups of this controller, the newest first, with the files that are missing in each. ▲ marks one that is not whole.</source>
        <translation>Les sauvegardes de ce contrôleur, la plus récente en premier, avec les fichiers qui manquent dans chacune. ▲ marque une sauvegarde incomplète.</translation>
    </message>
    <message>
        <source>Back up now reads every file into a new folder with a checksum of each. A file that fails does not stop the rest.</source>
        <translation>«&#xa0;Sauvegarder maintenant&#xa0;» lit chaque fichier dans un nouveau dossier, avec une somme de contrôle pour chacun. Un fichier en échec n’arrête pas les autres.</translation>
    </message>
    <message>
        <source>Verify reads every byte again. Compare finds what differs from another backup or from the controller now; dates and counters are left out, and the page says which.</source>
        <translation>«&#xa0;Vérifier&#xa0;» relit chaque octet. «&#xa0;Comparer&#xa0;» trouve ce qui diffère d’une autre sauvegarde ou du contrôleur à l’instant présent&#xa0;; les dates et les compteurs sont exclus, et la page indique lesquels.</translation>
    </message>
    <message>
        <source>Restore… plans first, makes a fresh backup, sends what changed, and reads it back. It needs an engineer and REMOTE, and no job may run.</source>
        <translation>«&#xa0;Restaurer…&#xa0;» planifie d’abord, crée une nouvelle sauvegarde, envoie ce qui a changé et le relit. Cela exige le niveau Ingénierie et REMOTE, et aucun job ne doit être en marche.</translation>
    </message>
    <message>
        <source>Old backups go by number and age as set below the list, never the last good one or a pinned one.</source>
        <translation>Les anciennes sauvegardes sont supprimées selon le nombre et l’âge réglés sous la liste, jamais la dernière correcte ni une sauvegarde épinglée.</translation>
    </message>
    <message>
        <source>Everything that was tried from here: writes, starts, moves, servo, files, and what was refused or withheld, with user, old and new value, and the controller&apos;s answer.</source>
        <translation>Tout ce qui a été tenté d’ici&#xa0;: écritures, démarrages, mouvements, servo, fichiers, ainsi que ce qui a été refusé ou non envoyé, avec l’utilisateur, l’ancienne et la nouvelle valeur, et la réponse du contrôleur.</translation>
    </message>
    <message>
        <source>“Unknown” means that no answer came: it may have happened.</source>
        <translation>«&#xa0;Inconnu&#xa0;» signifie qu’aucune réponse n’est arrivée&#xa0;: l’action a pu avoir lieu.</translation>
    </message>
    <message>
        <source>Filter by controller, kind, time and outcome, or search in all texts. Older records come when scrolling down.</source>
        <translation>Filtrer par contrôleur, type, heure et résultat, ou rechercher dans tous les textes. Les entrées plus anciennes apparaissent en faisant défiler vers le bas.</translation>
    </message>
    <message>
        <source>The journal is kept on this computer for all controllers and can be read without a connection. Export writes what the filter shows.</source>
        <translation>Le journal est conservé sur cet ordinateur pour tous les contrôleurs et peut être lu sans connexion. «&#xa0;Exporter…&#xa0;» écrit ce que le filtre affiche.</translation>
    </message>
    <message>
        <source>Go to a signal</source>
        <translation>Aller à un signal</translation>
    </message>
    <message>
        <source>Write the signal (network inputs)</source>
        <translation>Écrire le signal (entrées réseau)</translation>
    </message>
    <message>
        <source>On the tab Watch: watch the signal no longer</source>
        <translation>Dans l’onglet «&#xa0;Suivre&#xa0;»&#xa0;: ne plus suivre le signal</translation>
    </message>
    <message>
        <source>Go to a register</source>
        <translation>Aller à un registre</translation>
    </message>
    <message>
        <source>Open the editor; in it: stage the value</source>
        <translation>Ouvrir l’éditeur&#xa0;; dans celui-ci&#xa0;: préparer la valeur</translation>
    </message>
    <message>
        <source>Discard the staged value</source>
        <translation>Abandonner la valeur préparée</translation>
    </message>
    <message>
        <source>Copy the chosen rows</source>
        <translation>Copier les lignes choisies</translation>
    </message>
    <message>
        <source>Paste cells: they are staged after a preview</source>
        <translation>Coller des cellules&#xa0;: elles sont préparées après un aperçu</translation>
    </message>
    <message>
        <source>Go to a variable</source>
        <translation>Aller à une variable</translation>
    </message>
    <message>
        <source>Held on a jog button: steps, if keyboard jog was switched on</source>
        <translation>Maintenu sur un bouton de déplacement manuel&#xa0;: pas successifs, si le déplacement manuel au clavier a été activé</translation>
    </message>
    <message>
        <source>In the sheet of the move, after typing its words: move</source>
        <translation>Dans la fenêtre du mouvement, après avoir saisi son texte&#xa0;: déplacer</translation>
    </message>
    <message>
        <source>In the plot: move the cursor</source>
        <translation>Dans la courbe&#xa0;: déplacer le curseur</translation>
    </message>
    <message>
        <source>In the plot: cursor to the oldest or newest time in view</source>
        <translation>Dans la courbe&#xa0;: placer le curseur sur l’instant affiché le plus ancien ou le plus récent</translation>
    </message>
    <message>
        <source>In the plot: take the cursor away</source>
        <translation>Dans la courbe&#xa0;: retirer le curseur</translation>
    </message>
    <message>
        <source>In the list of signals: remove it from the trend</source>
        <translation>Dans la liste des signaux&#xa0;: retirer le signal de la tendance</translation>
    </message>
    <message>
        <source>In the start sheet, after typing its words: start</source>
        <translation>Dans la fenêtre de démarrage, après avoir saisi son texte&#xa0;: démarrer</translation>
    </message>
    <message>
        <source>Copy the chosen rows of the list with the focus</source>
        <translation>Copier les lignes choisies de la liste qui a le focus</translation>
    </message>
    <message>
        <source>“Job” is what the controller names: at rest the job that a start would begin, else the one that runs. “Run” says which.</source>
        <translation>«&#xa0;Job&#xa0;» est celui que nomme le contrôleur&#xa0;: à l’arrêt, le job qu’un démarrage lancerait, sinon celui qui est en marche. «&#xa0;Marche&#xa0;» indique lequel.</translation>
    </message>
    <message>
        <source>All controllers side by side: those in alarm first, then those without a link and those that are held, then the others in a fixed order.</source>
        <translation>Tous les contrôleurs côte à côte&#xa0;: d’abord ceux en alarme, puis ceux sans liaison et ceux en HOLD, puis les autres dans un ordre fixe.</translation>
    </message>
    <message>
        <source>A click opens a controller’s pages. The others stay connected and are read once a second.</source>
        <translation>Un clic ouvre les pages d’un contrôleur. Les autres restent connectés et sont lus une fois par seconde.</translation>
    </message>
    <message>
        <source>HOLD ALL orders a software hold at every controller that is not off, asks nothing, and says of each whether it was confirmed. It is no emergency stop.</source>
        <translation>HOLD TOUS ordonne un HOLD logiciel à chaque contrôleur qui n’est pas OFF, ne demande rien et indique pour chacun s’il a été confirmé. Ce n’est pas un arrêt d’urgence.</translation>
    </message>
    <message>
        <source>Connect all and Back up all only read. Nothing else goes to several controllers at once.</source>
        <translation>«&#xa0;Tout connecter&#xa0;» et «&#xa0;Tout sauvegarder&#xa0;» ne font que lire. Rien d’autre n’est envoyé à plusieurs contrôleurs à la fois.</translation>
    </message>
    <message>
        <source>Fleet</source>
        <translation>Parc</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Valeurs séparées par des virgules (*.csv)</translation>
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
        <translation>Un groupe de signaux et une variable B ont été demandés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>A signal group and a B variable are asked for while this sheet is open. Writing needs no REMOTE; whether data are protected cannot be read.</source>
        <translation>Un groupe de signaux et une variable B sont demandés tant que cette fenêtre est ouverte. L’écriture n’exige pas REMOTE&#xa0;; on ne peut pas lire si des données sont protégées.</translation>
    </message>
    <message>
        <source>The software version, which tells the model, was not read yet.</source>
        <translation>La version du logiciel, qui indique le modèle, n’a pas encore été lue.</translation>
    </message>
    <message>
        <source>The profile says %1, but %2 is the software of a %3.</source>
        <translation>Le profil indique %1, mais %2 est le logiciel d’un %3.</translation>
    </message>
    <message>
        <source>The software %1 does not tell the model. The ranges are those of the profile&apos;s %2.</source>
        <translation>Le logiciel %1 n’indique pas le modèle. Les plages sont celles du %2 du profil.</translation>
    </message>
    <message>
        <source>The software %1 is that of a %2. Its ranges come from a table, not from the controller.</source>
        <translation>Le logiciel %1 est celui d’un %2. Ses plages viennent d’une table, pas du contrôleur.</translation>
    </message>
    <message>
        <source>The last HOLD was refused: %1.</source>
        <translation>Le dernier HOLD a été refusé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The last HOLD was confirmed by the status. It is a software hold, no emergency stop.</source>
        <translation>Le dernier HOLD a été confirmé par l’état. C’est un HOLD logiciel, pas un arrêt d’urgence.</translation>
    </message>
    <message>
        <source>The last HOLD was sent, and the status did not confirm it.</source>
        <translation>Le dernier HOLD a été envoyé, et l’état ne l’a pas confirmé.</translation>
    </message>
    <message>
        <source>It needs neither REMOTE nor an access level, and was not tried. It is a software hold, no emergency stop.</source>
        <translation>Il n’exige ni REMOTE ni niveau d’accès et n’a pas été essayé. C’est un HOLD logiciel, pas un arrêt d’urgence.</translation>
    </message>
    <message>
        <source>A list of jobs was asked for at port %1: %2.</source>
        <translation>Une liste des jobs a été demandée au port %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>A list of jobs is asked for at port %1.</source>
        <translation>Une liste des jobs est demandée au port %1.</translation>
    </message>
    <message>
        <source>Port %1 lists the jobs. Sending and deleting files need REMOTE.</source>
        <translation>Le port %1 liste les jobs. L’envoi et la suppression de fichiers exigent REMOTE.</translation>
    </message>
    <message>
        <source>This simulation has B000 at number %1 on the network.</source>
        <translation>Cette simulation a B000 au numéro %1 sur le réseau.</translation>
    </message>
    <message>
        <source>The software version, with which it was compared, was not read yet.</source>
        <translation>La version du logiciel avec laquelle la comparaison a été faite n’a pas encore été lue.</translation>
    </message>
    <message>
        <source>It was compared with software %1, but %2 runs now: variables are not written before it is compared again.</source>
        <translation>La comparaison a été faite avec le logiciel %1, mais c’est %2 qui est exécuté maintenant&#xa0;: les variables ne sont pas écrites avant une nouvelle comparaison.</translation>
    </message>
    <message>
        <source>Whether B000 is number 0 or 1 on the network is unverified; variables are not written.</source>
        <translation>On n’a pas vérifié si B000 porte le numéro 0 ou 1 sur le réseau&#xa0;; les variables ne sont pas écrites.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1: number 0 on the network is B000.</source>
        <translation>Comparé avec le boîtier de programmation le %1&#xa0;: le numéro 0 sur le réseau est B000.</translation>
    </message>
    <message>
        <source>Compared with the pendant on %1, shifted: number 1 on the network is B000.</source>
        <translation>Comparé avec le boîtier de programmation le %1, décalé&#xa0;: le numéro 1 sur le réseau est B000.</translation>
    </message>
    <message>
        <source>The controller does not answer any more. Reading resumes by itself.</source>
        <translation>Le contrôleur ne répond plus. La lecture reprend automatiquement.</translation>
    </message>
    <message>
        <source>The controller tells its status and system information. Reading needs no REMOTE.</source>
        <translation>Le contrôleur communique son état et ses informations système. La lecture n’exige pas REMOTE.</translation>
    </message>
    <message>
        <source>Orders are taken in command remote alone: start, select, reset, cycle, servo on.</source>
        <translation>Les ordres ne sont acceptés qu’en CMD REMOTE&#xa0;: démarrage, sélection, réinitialisation, cycle, Servo ON.</translation>
    </message>
    <message>
        <source>It needs REMOTE, and that no job runs.</source>
        <translation>Il faut REMOTE, et qu’aucun job ne soit en marche.</translation>
    </message>
    <message>
        <source>It needs PLAY, REMOTE, servo on and a job, and nothing that holds the robot.</source>
        <translation>Il faut PLAY, REMOTE, Servo ON et un job, et que rien ne maintienne le robot en HOLD.</translation>
    </message>
    <message>
        <source>It needs PLAY and REMOTE. Servo off can always be ordered from here; whether it is taken without REMOTE is up to the controller.</source>
        <translation>Il faut PLAY et REMOTE. Servo OFF peut toujours être ordonné d’ici&#xa0;; c’est le contrôleur qui décide s’il l’accepte sans REMOTE.</translation>
    </message>
    <message>
        <source>They need what a start needs, but for the job, and a model that knows them.</source>
        <translation>Ils exigent ce qu’exige un démarrage, sauf le job, ainsi qu’un modèle qui les connaît.</translation>
    </message>
    <message>
        <source>Sending a file that exists there needs REMOTE and two parameters.</source>
        <translation>L’envoi d’un fichier qui y existe déjà exige REMOTE et deux paramètres.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>I/O and variables</source>
        <translation>E/S et variables</translation>
    </message>
    <message>
        <source>Ranges of the model</source>
        <translation>Plages du modèle</translation>
    </message>
    <message>
        <source>Orders (REMOTE)</source>
        <translation>Ordres (REMOTE)</translation>
    </message>
    <message>
        <source>Selecting a job</source>
        <translation>Sélection d’un job</translation>
    </message>
    <message>
        <source>Starting a job</source>
        <translation>Démarrage d’un job</translation>
    </message>
    <message>
        <source>Switching servo on</source>
        <translation>Activation du servo</translation>
    </message>
    <message>
        <source>Jog and move</source>
        <translation>Déplacement manuel et mouvement</translation>
    </message>
    <message>
        <source>HOLD (software)</source>
        <translation>HOLD (logiciel)</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Replacing files</source>
        <translation>Remplacement de fichiers</translation>
    </message>
    <message>
        <source>Numbering of variables</source>
        <translation>Numérotation des variables</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>autorisé</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>non autorisé</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>illisible</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>pas encore lu</translation>
    </message>
    <message>
        <source>In the way: %1.</source>
        <translation>Obstacles&#xa0;: %1.</translation>
    </message>
    <message>
        <source>HSES does not tell whether this is so: %1.</source>
        <translation>HSES n’indique pas si c’est le cas&#xa0;: %1.</translation>
    </message>
    <message>
        <source>What helps: %1.</source>
        <translation>Remède&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Diagnose… in the rail finds out at which step it fails.</source>
        <translation>«&#xa0;Diagnostiquer…&#xa0;» dans la barre de navigation indique à quelle étape cela échoue.</translation>
    </message>
    <message>
        <source>Correct the model in the profile (Connect…).</source>
        <translation>Corriger le modèle dans le profil («&#xa0;Connecter…&#xa0;»).</translation>
    </message>
    <message>
        <source>Use the pendant.</source>
        <translation>Utiliser le boîtier de programmation.</translation>
    </message>
    <message>
        <source>Pendesk %1, readiness of %2 (%3), %4, %5</source>
        <translation>Pendesk %1, disponibilité de %2 (%3), %4, %5</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <comment>subject, allowance, evidence</comment>
        <translation>%1&#xa0;: %2, %3</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>La ligne n’a pas les nombres attendus à cet endroit.</translation>
    </message>
</context>
<context>
    <name>Shown</name>
    <message>
        <source>Not read yet.</source>
        <translation>Pas encore lu.</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Refusé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Last seen %1</source>
        <translation>Dernière lecture %1</translation>
    </message>
    <message>
        <source>not taught</source>
        <translation>non appris</translation>
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
        <translation>non</translation>
    </message>
    <message>
        <source>PENDANT</source>
        <translation>BOÎTIER</translation>
    </message>
    <message>
        <source>EXTERNAL</source>
        <translation>EXTERNE</translation>
    </message>
    <message>
        <source>COMMAND</source>
        <translation>COMMANDE</translation>
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
        <translation>AUCUN MODE</translation>
    </message>
    <message>
        <source>REMOTE %1</source>
        <translation>REMOTE %1</translation>
    </message>
    <message>
        <source>STEP</source>
        <translation>PAS À PAS</translation>
    </message>
    <message>
        <source>1 CYCLE</source>
        <translation>1 CYCLE</translation>
    </message>
    <message>
        <source>CONTINUOUS</source>
        <translation>CONTINU</translation>
    </message>
    <message>
        <source>NO CYCLE</source>
        <translation>AUCUN CYCLE</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>EN MARCHE</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
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
        <translation>néant</translation>
    </message>
    <message>
        <source>off</source>
        <translation>off</translation>
    </message>
    <message>
        <source>ALARM</source>
        <translation>ALARME</translation>
    </message>
    <message>
        <source>ERROR</source>
        <translation>ERREUR</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarme</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>held</source>
        <translation>en HOLD</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>contradictoire</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en marche</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>line %1 · step %2 · %3</source>
        <translation>ligne %1 · pas %2 · %3</translation>
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
        <translation>impulsions</translation>
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
        <translation>HOLD demandé, %1 s…</translation>
    </message>
    <message>
        <source>held by command</source>
        <translation>HOLD par commande</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>HOLD par le boîtier de programmation</translation>
    </message>
    <message>
        <source>held externally</source>
        <translation>HOLD externe</translation>
    </message>
    <message>
        <source>HOLD refused</source>
        <translation>HOLD refusé</translation>
    </message>
    <message>
        <source>HOLD not confirmed</source>
        <translation>HOLD non confirmé</translation>
    </message>
    <message>
        <source>released</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>HOLD logiciel · touche Pause</translation>
    </message>
</context>
<context>
    <name>cell::Sentences</name>
    <message>
        <source>%1 changed</source>
        <translation>%1 modifié</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nouveau</translation>
    </message>
    <message>
        <source>%1: gone.</source>
        <translation>%1&#xa0;: disparu.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) differ, from line %1 on.</source>
        <translation>
            <numerusform>%n ligne diffère, à partir de la ligne %1.</numerusform>
            <numerusform>%n lignes diffèrent, à partir de la ligne %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>The newer file is empty; what stood in it is not known to be deleted.</source>
        <translation>Le fichier le plus récent est vide&#xa0;; on ne sait pas si ce qu’il contenait est supprimé.</translation>
    </message>
    <message>
        <source>The older file is empty.</source>
        <translation>Le fichier le plus ancien est vide.</translation>
    </message>
    <message numerus="yes">
        <source>And %n more difference(s).</source>
        <translation>
            <numerusform>Et %n autre différence.</numerusform>
            <numerusform>Et %n autres différences.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes; the content differs.</source>
        <translation>%1 octets&#xa0;; le contenu diffère.</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>moved %1 mm (%2)</source>
        <translation>déplacé de %1 mm (%2)</translation>
    </message>
    <message>
        <source>turned %1 deg (%2)</source>
        <translation>tourné de %1 deg (%2)</translation>
    </message>
    <message numerus="yes">
        <source>Used by %n job(s).</source>
        <translation>
            <numerusform>Utilisé par %n job.</numerusform>
            <numerusform>Utilisé par %n jobs.</numerusform>
        </translation>
    </message>
    <message>
        <source>could not be read in one of the files</source>
        <translation>n’a pas pu être lu dans l’un des fichiers</translation>
    </message>
    <message>
        <source>name %1</source>
        <translation>nom %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>point %1</translation>
    </message>
    <message>
        <source>weight %1 kg</source>
        <translation>poids %1 kg</translation>
    </message>
    <message>
        <source>centre of gravity %1 mm</source>
        <translation>centre de gravité %1 mm</translation>
    </message>
    <message>
        <source>inertia %1 kgm²</source>
        <translation>inertie %1 kgm²</translation>
    </message>
    <message>
        <source>kind of entry %1</source>
        <translation>type de saisie %1</translation>
    </message>
    <message>
        <source>%1 is new.</source>
        <translation>%1 est nouveau.</translation>
    </message>
    <message>
        <source>%1 is gone.</source>
        <translation>%1 a disparu.</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Outil %1</translation>
    </message>
    <message>
        <source>User frame %1</source>
        <translation>Repère utilisateur %1</translation>
    </message>
    <message>
        <source>where it lies could not be read in one of the files</source>
        <translation>sa position n’a pas pu être lue dans l’un des fichiers</translation>
    </message>
    <message>
        <source>taught with tool %1</source>
        <translation>appris avec l’outil %1</translation>
    </message>
    <message>
        <source>taught at other points</source>
        <translation>appris en d’autres points</translation>
    </message>
    <message>
        <source>Area %1</source>
        <translation>Zone %1</translation>
    </message>
    <message>
        <source>set</source>
        <translation>défini</translation>
    </message>
    <message>
        <source>no longer set</source>
        <translation>n’est plus défini</translation>
    </message>
    <message>
        <source>upper %1 %2 mm</source>
        <translation>limite sup. %1 %2 mm</translation>
    </message>
    <message>
        <source>lower %1 %2 mm</source>
        <translation>limite inf. %1 %2 mm</translation>
    </message>
    <message>
        <source>other coordinates or another group</source>
        <translation>autres coordonnées ou autre groupe</translation>
    </message>
    <message>
        <source>Collision detection, set %1, group %2</source>
        <translation>Détection de collision, jeu %1, groupe %2</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>switched on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>level %1</source>
        <translation>niveau %1</translation>
    </message>
    <message>
        <source>robot %1 limit %2 %3 %4 deg</source>
        <translation>robot %1 limite %2 %3 %4 deg</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>modifié</translation>
    </message>
    <message>
        <source>meaning not known</source>
        <translation>signification inconnue</translation>
    </message>
    <message>
        <source>Section %1 has %2 values.</source>
        <translation>La section %1 a %2 valeurs.</translation>
    </message>
    <message>
        <source>System part</source>
        <translation>Partie système</translation>
    </message>
    <message>
        <source>User part</source>
        <translation>Partie utilisateur</translation>
    </message>
    <message>
        <source>decides %1</source>
        <translation>détermine %1</translation>
    </message>
    <message>
        <source>%1, instruction %2: %3</source>
        <translation>%1, instruction %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 became %2</source>
        <translation>%1 est devenu %2</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1 est nouveau</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 a disparu</translation>
    </message>
    <message>
        <source>Now also written: %1.</source>
        <translation>Désormais aussi écrit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No longer written: %1.</source>
        <translation>N’est plus écrit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The control group %1 is another one.</source>
        <translation>Le groupe d’axes %1 est différent.</translation>
    </message>
    <message>
        <source>Another number of control groups.</source>
        <translation>Nombre de groupes d’axes différent.</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>The hours of control power went back by %1: another controller, or its memory was cleared.</source>
        <translation>Les heures de mise sous tension ont reculé de %1&#xa0;: autre contrôleur, ou sa mémoire a été effacée.</translation>
    </message>
    <message>
        <source>%1 powered in between.</source>
        <translation>%1 sous tension entre-temps.</translation>
    </message>
    <message>
        <source>Section %1 is new.</source>
        <translation>La section %1 est nouvelle.</translation>
    </message>
    <message>
        <source>Section %1 is not in the newer file.</source>
        <translation>La section %1 n’est pas dans le fichier le plus récent.</translation>
    </message>
    <message>
        <source>Presets of timers and counters changed.</source>
        <translation>Présélections de temporisateurs et compteurs modifiées.</translation>
    </message>
    <message>
        <source>Home position of %1 axis %2 recalibrated (%3): taught points may be off.</source>
        <translation>Position d’origine de %1 axe %2 recalibrée (%3)&#xa0;: les points appris peuvent être décalés.</translation>
    </message>
    <message>
        <source>Position of %1 axis %2: %3 pulses.</source>
        <translation>Position de %1 axe %2&#xa0;: %3 impulsions.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>on</translation>
    </message>
    <message>
        <source>off</source>
        <translation>off</translation>
    </message>
    <message>
        <source> Command remote select: HSES control is permitted.</source>
        <translation> CMD REMOTE SEL&#xa0;: la commande par HSES est autorisée.</translation>
    </message>
    <message>
        <source> Command remote select: HSES control will be refused.</source>
        <translation> CMD REMOTE SEL&#xa0;: la commande par HSES sera refusée.</translation>
    </message>
    <message>
        <source>Pseudo input %1 switched %2.</source>
        <translation>Pseudo-entrée %1 commutée&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>Parameter version</source>
        <translation>Version des paramètres</translation>
    </message>
    <message>
        <source>Robots</source>
        <translation>Robots</translation>
    </message>
    <message>
        <source>Applications</source>
        <translation>Applications</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>Cartes</translation>
    </message>
    <message numerus="yes">
        <source>%n new entry(ies).</source>
        <translation>
            <numerusform>%n nouvelle entrée.</numerusform>
            <numerusform>%n nouvelles entrées.</numerusform>
        </translation>
    </message>
    <message>
        <source>The log rolled over: edits in between are not known.</source>
        <translation>Le journal a débordé&#xa0;: les modifications intermédiaires sont inconnues.</translation>
    </message>
    <message numerus="yes">
        <source>%n new alarm(s): %1.</source>
        <translation>
            <numerusform>%n nouvelle alarme&#xa0;: %1.</numerusform>
            <numerusform>%n nouvelles alarmes&#xa0;: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>coordinates %1</source>
        <translation>coordonnées %1</translation>
    </message>
    <message>
        <source>tool %1</source>
        <translation>outil %1</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>repère utilisateur %1</translation>
    </message>
    <message>
        <source>form of the arm</source>
        <translation>configuration du bras</translation>
    </message>
    <message>
        <source>now set (%1)</source>
        <translation>désormais défini (%1)</translation>
    </message>
    <message>
        <source>Number of variables %1</source>
        <translation>Nombre de variables %1</translation>
    </message>
    <message>
        <source>%1 lost its name “%2”.</source>
        <translation>%1 a perdu son nom «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>%1 is now named “%2”.</source>
        <translation>%1 s’appelle désormais «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>%1 “%2” is now named “%3”.</source>
        <translation>%1 «&#xa0;%2&#xa0;» s’appelle désormais «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>written</source>
        <translation>écrit</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lu</translation>
    </message>
    <message>
        <source>waited for</source>
        <translation>attendu</translation>
    </message>
    <message>
        <source>called</source>
        <translation>appelé</translation>
    </message>
    <message>
        <source>jumped to</source>
        <translation>cible de saut</translation>
    </message>
    <message>
        <source>started</source>
        <translation>lancé</translation>
    </message>
    <message>
        <source>named</source>
        <translation>nommé</translation>
    </message>
    <message>
        <source>may be %1</source>
        <translation>peut-être %1</translation>
    </message>
    <message>
        <source>%1 line %2</source>
        <translation>%1 ligne %2</translation>
    </message>
    <message>
        <source>%1 is called, and no file has it: %2.</source>
        <translation>%1 est appelé, et aucun fichier ne le contient : %2.</translation>
    </message>
    <message>
        <source>%1 is written in several places: %2.</source>
        <translation>%1 est écrit à plusieurs endroits : %2.</translation>
    </message>
    <message>
        <source>%1 is read and never written in the files: %2.</source>
        <translation>%1 est lu et n’est jamais écrit dans les fichiers : %2.</translation>
    </message>
    <message>
        <source>%1 has several names: %2.</source>
        <translation>%1 a plusieurs noms : %2.</translation>
    </message>
    <message>
        <source>%1 is used and its data were not entered: %2.</source>
        <translation>%1 est utilisé sans que ses données aient été saisies : %2.</translation>
    </message>
    <message>
        <source>%1 is named by no other job and no macro.</source>
        <translation>%1 n’est nommé par aucun autre job ni aucune macro.</translation>
    </message>
</context>
<context>
    <name>cellfiles::Sentences</name>
    <message>
        <source>values</source>
        <translation>valeurs</translation>
    </message>
    <message>
        <source>block</source>
        <translation>bloc</translation>
    </message>
    <message>
        <source>entry</source>
        <translation>entrée</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>job</source>
        <translation>job</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>text</source>
        <translation>texte</translation>
    </message>
    <message>
        <source>collision detection</source>
        <translation>détection de collision</translation>
    </message>
    <message>
        <source>set</source>
        <translation>jeu</translation>
    </message>
    <message>
        <source>group</source>
        <translation>groupe</translation>
    </message>
    <message>
        <source>on</source>
        <translation>on</translation>
    </message>
    <message>
        <source>level</source>
        <translation>niveau</translation>
    </message>
    <message>
        <source>reasons of stops</source>
        <translation>motifs d’arrêt</translation>
    </message>
    <message>
        <source>number</source>
        <translation>numéro</translation>
    </message>
    <message>
        <source>date</source>
        <translation>date</translation>
    </message>
    <message>
        <source>reasons</source>
        <translation>motifs</translation>
    </message>
    <message>
        <source>The line does not have the numbers that belong there.</source>
        <translation>La ligne n’a pas les nombres attendus à cet endroit.</translation>
    </message>
    <message>
        <source>The block has no number.</source>
        <translation>Le bloc n’a pas de numéro.</translation>
    </message>
    <message>
        <source>Tool %1 is not complete.</source>
        <translation>L’outil %1 n’est pas complet.</translation>
    </message>
    <message>
        <source>User frame %1 is not complete: where it lies is unknown.</source>
        <translation>Le repère utilisateur %1 n’est pas complet&#xa0;: sa position est inconnue.</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>User frames</source>
        <translation>Repères utilisateur</translation>
    </message>
    <message>
        <source>Interference areas</source>
        <translation>Zones d’interférence</translation>
    </message>
    <message>
        <source>Collision detection</source>
        <translation>Détection de collision</translation>
    </message>
    <message>
        <source>Weaving conditions</source>
        <translation>Conditions de balayage</translation>
    </message>
    <message>
        <source>Arc start conditions</source>
        <translation>Conditions de début d’arc</translation>
    </message>
    <message>
        <source>Arc end conditions</source>
        <translation>Conditions de fin d’arc</translation>
    </message>
    <message>
        <source>Arc auxiliary conditions</source>
        <translation>Conditions auxiliaires d’arc</translation>
    </message>
    <message>
        <source>Welders</source>
        <translation>Postes de soudage</translation>
    </message>
    <message>
        <source>Cutting shapes</source>
        <translation>Formes de coupe</translation>
    </message>
    <message>
        <source>Maintenance conditions</source>
        <translation>Conditions de maintenance</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Names of variables</source>
        <translation>Noms des variables</translation>
    </message>
    <message>
        <source>Names of signals</source>
        <translation>Noms des signaux</translation>
    </message>
    <message>
        <source>Names of external signals</source>
        <translation>Noms des signaux externes</translation>
    </message>
    <message>
        <source>Names of registers</source>
        <translation>Noms des registres</translation>
    </message>
    <message>
        <source>Names of timers</source>
        <translation>Noms des temporisateurs</translation>
    </message>
    <message>
        <source>Timers</source>
        <translation>Temporisateurs</translation>
    </message>
    <message>
        <source>Timer settings</source>
        <translation>Réglages des temporisateurs</translation>
    </message>
    <message>
        <source>Watch list</source>
        <translation>Liste de suivi</translation>
    </message>
    <message>
        <source>Groups of signals</source>
        <translation>Groupes de signaux</translation>
    </message>
    <message>
        <source>User words</source>
        <translation>Mots de l’utilisateur</translation>
    </message>
    <message>
        <source>User menus</source>
        <translation>Menus utilisateur</translation>
    </message>
    <message>
        <source>Names of flags</source>
        <translation>Noms des indicateurs</translation>
    </message>
    <message>
        <source>Key functions</source>
        <translation>Fonctions des touches</translation>
    </message>
    <message>
        <source>Interface panels</source>
        <translation>Panneaux d’interface</translation>
    </message>
    <message>
        <source>Macro commands</source>
        <translation>Commandes macro</translation>
    </message>
    <message>
        <source>Ladder</source>
        <translation>Programme ladder</translation>
    </message>
    <message>
        <source>Pseudo inputs</source>
        <translation>Pseudo-entrées</translation>
    </message>
    <message>
        <source>I/O boards</source>
        <translation>Cartes E/S</translation>
    </message>
    <message>
        <source>I/O axes</source>
        <translation>Axes d’E/S</translation>
    </message>
    <message>
        <source>EtherNet/IP</source>
        <translation>EtherNet/IP</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Réseau</translation>
    </message>
    <message>
        <source>Address translation</source>
        <translation>Traduction d’adresses</translation>
    </message>
    <message>
        <source>Remote users</source>
        <translation>Utilisateurs distants</translation>
    </message>
    <message>
        <source>Home positions of the encoders</source>
        <translation>Positions d’origine des codeurs</translation>
    </message>
    <message>
        <source>Second home position</source>
        <translation>Seconde position d’origine</translation>
    </message>
    <message>
        <source>Operation origin</source>
        <translation>Origine de travail</translation>
    </message>
    <message>
        <source>Robot calibration</source>
        <translation>Calibrage des robots</translation>
    </message>
    <message>
        <source>Tool interference</source>
        <translation>Interférence d’outil</translation>
    </message>
    <message>
        <source>Arrangement of robots</source>
        <translation>Disposition des robots</translation>
    </message>
    <message>
        <source>Approach buzzer</source>
        <translation>Avertisseur d’approche</translation>
    </message>
    <message>
        <source>Servo assistance</source>
        <translation>Assistance servo</translation>
    </message>
    <message>
        <source>Safety logic</source>
        <translation>Logique de sécurité</translation>
    </message>
    <message>
        <source>Range limits</source>
        <translation>Limites de plage</translation>
    </message>
    <message>
        <source>Axis speed monitor</source>
        <translation>Surveillance de vitesse d’axe</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>Limites de vitesse</translation>
    </message>
    <message>
        <source>Tool angle monitor</source>
        <translation>Surveillance d’angle d’outil</translation>
    </message>
    <message>
        <source>Check sums of safety data</source>
        <translation>Sommes de contrôle des données de sécurité</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>System, options and change dates</source>
        <translation>Système, options et dates de modification</translation>
    </message>
    <message>
        <source>Operation log</source>
        <translation>Journal des opérations</translation>
    </message>
    <message>
        <source>Alarm history</source>
        <translation>Historique des alarmes</translation>
    </message>
    <message>
        <source>Message history</source>
        <translation>Historique des messages</translation>
    </message>
    <message>
        <source>Fast events</source>
        <translation>Événements rapides</translation>
    </message>
    <message>
        <source>Reasons of stops</source>
        <translation>Motifs d’arrêt</translation>
    </message>
    <message>
        <source>Maintenance counters</source>
        <translation>Compteurs de maintenance</translation>
    </message>
    <message>
        <source>Torque counters</source>
        <translation>Compteurs de couple</translation>
    </message>
    <message>
        <source>Encoder heat</source>
        <translation>Température des codeurs</translation>
    </message>
    <message>
        <source>Step diagnosis</source>
        <translation>Diagnostic de pas</translation>
    </message>
    <message>
        <source>Job monitor</source>
        <translation>Surveillance des jobs</translation>
    </message>
    <message>
        <source>Robot monitor</source>
        <translation>Surveillance du robot</translation>
    </message>
    <message>
        <source>Servo monitor</source>
        <translation>Surveillance servo</translation>
    </message>
    <message>
        <source>Regeneration unit</source>
        <translation>Unité de régénération</translation>
    </message>
    <message>
        <source>Memory image</source>
        <translation>Image mémoire</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Unknown file</source>
        <translation>Fichier inconnu</translation>
    </message>
    <message>
        <source>The file ends before the values of %1.</source>
        <translation>Le fichier se termine avant les valeurs de %1.</translation>
    </message>
    <message>
        <source>The control groups of this line could not be read.</source>
        <translation>Les groupes d’axes de cette ligne n’ont pas pu être lus.</translation>
    </message>
    <message>
        <source>This section is not understood.</source>
        <translation>Cette section n’est pas comprise.</translation>
    </message>
    <message>
        <source>“%1” is not understood.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas compris.</translation>
    </message>
    <message>
        <source>The record in front of this date is not understood.</source>
        <translation>L’enregistrement qui précède cette date n’est pas compris.</translation>
    </message>
    <message>
        <source>The record that begins here is not complete.</source>
        <translation>L’enregistrement qui commence ici n’est pas complet.</translation>
    </message>
    <message>
        <source>The section %1 announces %2 records and holds %3.</source>
        <translation>La section %1 annonce %2 enregistrements et en contient %3.</translation>
    </message>
    <message>
        <source>The entry is numbered %1 and is number %2 by its place.</source>
        <translation>L’entrée porte le numéro %1 et, par sa place, est le numéro %2.</translation>
    </message>
    <message>
        <source>The entry is not complete.</source>
        <translation>L’entrée n’est pas complète.</translation>
    </message>
    <message>
        <source>The number of the macro cannot be read.</source>
        <translation>Le numéro de la macro ne peut pas être lu.</translation>
    </message>
    <message>
        <source>The line holds NUL bytes.</source>
        <translation>La ligne contient des octets NUL.</translation>
    </message>
    <message>
        <source>Lines end in LF alone. A pendant may take such a file for empty: convert it to CR LF before it is loaded.</source>
        <translation>Les lignes se terminent par LF seul. Un boîtier de programmation peut croire un tel fichier vide&#xa0;: le convertir en CR LF avant de le charger.</translation>
    </message>
    <message>
        <source>The file ends within a line: it may be cut.</source>
        <translation>Le fichier finit dans une ligne&#xa0;: peut-être tronqué.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Le fichier est vide.</translation>
    </message>
    <message>
        <source>The file is too long to be read.</source>
        <translation>Le fichier est trop long pour être lu.</translation>
    </message>
    <message>
        <source>%1 has no section “%2”; the rows below it are not understood.</source>
        <translation>%1 n’a pas de section «&#xa0;%2&#xa0;»&#xa0;; les lignes en dessous ne sont pas comprises.</translation>
    </message>
    <message>
        <source>The row has %1 instead of 10 values; the missing ones of %2 are unknown.</source>
        <translation>La ligne a %1 valeurs au lieu de 10&#xa0;; celles qui manquent à %2 sont inconnues.</translation>
    </message>
    <message>
        <source>%1 is no number of 32 bits.</source>
        <translation>%1 n’est pas un nombre de 32 bits.</translation>
    </message>
    <message>
        <source>data transmission; 2 is over the network</source>
        <translation>transmission de données&#xa0;; 2 est par le réseau</translation>
    </message>
    <message>
        <source>numbering of variables for network clients; 1: by their number, 0: by their number plus one</source>
        <translation>numérotation des variables pour les clients réseau&#xa0;; 1&#xa0;: par leur numéro, 0&#xa0;: par leur numéro plus un</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files</source>
        <translation>1 autorise les clients réseau à écraser des fichiers</translation>
    </message>
    <message>
        <source>serial transmission: data bits, parity, stop, speed, timers</source>
        <translation>transmission série&#xa0;: bits de données, parité, arrêt, vitesse, temporisateurs</translation>
    </message>
    <message>
        <source>3 permits overwriting when loading from USB</source>
        <translation>3 autorise l’écrasement lors du chargement depuis USB</translation>
    </message>
    <message>
        <source>address and mask of the controller</source>
        <translation>adresse et masque du contrôleur</translation>
    </message>
    <message>
        <source>1 permits FTP</source>
        <translation>1 autorise FTP</translation>
    </message>
    <message>
        <source>1 permits network clients to overwrite files; the meaning of 2 is not known</source>
        <translation>1 autorise les clients réseau à écraser des fichiers&#xa0;; la signification de 2 est inconnue</translation>
    </message>
    <message>
        <source>addresses and masks</source>
        <translation>adresses et masques</translation>
    </message>
    <message>
        <source>0 permits selecting jobs in remote and play</source>
        <translation>0 autorise la sélection de jobs en REMOTE et PLAY</translation>
    </message>
    <message>
        <source>pendant operation in remote; 63 permits starts and edits</source>
        <translation>utilisation du boîtier en REMOTE&#xa0;; 63 autorise démarrages et modifications</translation>
    </message>
    <message>
        <source>alias function; 0 permits loading own names</source>
        <translation>fonction alias&#xa0;; 0 autorise le chargement de noms propres</translation>
    </message>
    <message>
        <source>drivers that start motion need 0</source>
        <translation>les pilotes qui lancent un mouvement exigent 0</translation>
    </message>
    <message>
        <source>MotoPlus and telnet settings</source>
        <translation>réglages MotoPlus et telnet</translation>
    </message>
    <message>
        <source>number of variables of each kind</source>
        <translation>nombre de variables de chaque type</translation>
    </message>
    <message>
        <source>control groups and their axes</source>
        <translation>groupes d’axes et leurs axes</translation>
    </message>
    <message>
        <source>pseudo input signals</source>
        <translation>signaux de pseudo-entrée</translation>
    </message>
    <message>
        <source>The name “%1” holds bytes that the text encoding does not know.</source>
        <translation>Le nom «&#xa0;%1&#xa0;» contient des octets que l’encodage du texte ne connaît pas.</translation>
    </message>
    <message>
        <source>The row has more than four names.</source>
        <translation>La ligne a plus de quatre noms.</translation>
    </message>
    <message>
        <source>There are more names than signals.</source>
        <translation>Il y a plus de noms que de signaux.</translation>
    </message>
    <message>
        <source>The row is not a number, two flags and a name.</source>
        <translation>La ligne n’est pas un nombre, deux indicateurs et un nom.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is beyond the %n variable(s) that the file announces.</source>
        <translation>
            <numerusform>%1 dépasse la %n variable que le fichier annonce.</numerusform>
            <numerusform>%1 dépasse les %n variables que le fichier annonce.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was named “%2” before; which name the pendant shows is not known.</source>
        <translation>%1 s’appelait «&#xa0;%2&#xa0;» auparavant&#xa0;; on ne sait pas quel nom le boîtier affiche.</translation>
    </message>
    <message>
        <source>The line stands in a section that names no signals.</source>
        <translation>La ligne se trouve dans une section qui ne nomme aucun signal.</translation>
    </message>
    <message>
        <source>The line does not announce a number for each of the eight kinds.</source>
        <translation>La ligne n’annonce pas un nombre pour chacun des huit types.</translation>
    </message>
    <message>
        <source>The hours could not be read.</source>
        <translation>Les heures n’ont pas pu être lues.</translation>
    </message>
    <message>
        <source>The file does not say the version of the system software.</source>
        <translation>Le fichier n’indique pas la version du logiciel système.</translation>
    </message>
    <message>
        <source>system</source>
        <translation>système</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>software</source>
        <translation>logiciel</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>paramètres</translation>
    </message>
    <message>
        <source>application</source>
        <translation>application</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n axis/axes</source>
        <translation>
            <numerusform>%1, %n axe</numerusform>
            <numerusform>%1, %n axes</numerusform>
        </translation>
    </message>
    <message>
        <source>boards</source>
        <translation>cartes</translation>
    </message>
    <message>
        <source>board</source>
        <translation>carte</translation>
    </message>
    <message>
        <source>hours</source>
        <translation>heures</translation>
    </message>
    <message>
        <source>counter</source>
        <translation>compteur</translation>
    </message>
    <message>
        <source>options</source>
        <translation>options</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nom</translation>
    </message>
    <message>
        <source>state</source>
        <translation>état</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>réglages</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>meaning</source>
        <translation>signification</translation>
    </message>
    <message>
        <source>ladder</source>
        <translation>programme ladder</translation>
    </message>
    <message>
        <source>part</source>
        <translation>partie</translation>
    </message>
    <message>
        <source>instruction</source>
        <translation>instruction</translation>
    </message>
    <message>
        <source>texts</source>
        <translation>textes</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tableau</translation>
    </message>
    <message>
        <source>operation log</source>
        <translation>journal des opérations</translation>
    </message>
    <message>
        <source>event</source>
        <translation>événement</translation>
    </message>
    <message>
        <source>alarm history</source>
        <translation>historique des alarmes</translation>
    </message>
    <message>
        <source>class</source>
        <translation>classe</translation>
    </message>
    <message>
        <source>code</source>
        <translation>code</translation>
    </message>
    <message>
        <source>detail</source>
        <translation>détail</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>mode</translation>
    </message>
    <message>
        <source>not entered</source>
        <translation>non saisi</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>measured load</source>
        <translation>charge mesurée</translation>
    </message>
    <message>
        <source>base coordinates</source>
        <translation>coordonnées base</translation>
    </message>
    <message>
        <source>robot coordinates</source>
        <translation>coordonnées robot</translation>
    </message>
    <message>
        <source>user frame %1</source>
        <translation>repère utilisateur %1</translation>
    </message>
    <message>
        <source>unused</source>
        <translation>inutilisé</translation>
    </message>
    <message>
        <source>tools</source>
        <translation>outils</translation>
    </message>
    <message>
        <source>weight kg</source>
        <translation>poids kg</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>saisi</translation>
    </message>
    <message>
        <source>user frames</source>
        <translation>repères utilisateur</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>outil</translation>
    </message>
    <message>
        <source>interference areas</source>
        <translation>zones d’interférence</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>coordonnées</translation>
    </message>
    <message>
        <source>lower X mm</source>
        <translation>X inf. mm</translation>
    </message>
    <message>
        <source>upper X mm</source>
        <translation>X sup. mm</translation>
    </message>
    <message>
        <source>lower Y mm</source>
        <translation>Y inf. mm</translation>
    </message>
    <message>
        <source>upper Y mm</source>
        <translation>Y sup. mm</translation>
    </message>
    <message>
        <source>lower Z mm</source>
        <translation>Z inf. mm</translation>
    </message>
    <message>
        <source>upper Z mm</source>
        <translation>Z sup. mm</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>non défini</translation>
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
        <translation>positions</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>repère utilisateur</translation>
    </message>
    <message>
        <source>form</source>
        <translation>configuration</translation>
    </message>
    <message>
        <source>names</source>
        <translation>noms</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>signal</translation>
    </message>
    <message>
        <source>register</source>
        <translation>registre</translation>
    </message>
    <message>
        <source>timer</source>
        <translation>temporisateur</translation>
    </message>
    <message>
        <source>home positions, pulses</source>
        <translation>positions d’origine, impulsions</translation>
    </message>
    <message>
        <source>pseudo inputs</source>
        <translation>pseudo-entrées</translation>
    </message>
    <message>
        <source>byte</source>
        <translation>octet</translation>
    </message>
    <message>
        <source>bits</source>
        <translation>bits</translation>
    </message>
    <message>
        <source>The value of %1 could not be read.</source>
        <translation>La valeur de %1 n’a pas pu être lue.</translation>
    </message>
    <message>
        <source>The file announces %1 variables %2 and has %3; the others are not known.</source>
        <translation>Le fichier annonce %1 variables %2 et en a %3&#xa0;; les autres sont inconnues.</translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>impulsion</translation>
    </message>
    <message>
        <source>tool coordinates</source>
        <translation>coordonnées outil</translation>
    </message>
    <message>
        <source>user coordinates</source>
        <translation>coordonnées utilisateur</translation>
    </message>
    <message>
        <source>master tool coordinates</source>
        <translation>coordonnées outil maître</translation>
    </message>
</context>
<context>
    <name>dialogs::AccessSettingsDialog</name>
    <message>
        <source>Passcode and idle time</source>
        <translation>Code d’accès et délai d’inactivité</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Back to Monitor after</source>
        <translation>Retour à Surveillance après</translation>
    </message>
    <message>
        <source>New passcode</source>
        <translation>Nouveau code d’accès</translation>
    </message>
    <message>
        <source>The same again</source>
        <translation>Le même à nouveau</translation>
    </message>
    <message>
        <source>Leave both empty for no passcode.</source>
        <translation>Laisser les deux champs vides pour aucun code d’accès.</translation>
    </message>
    <message>
        <source>The two are not the same.</source>
        <translation>Les deux ne sont pas identiques.</translation>
    </message>
</context>
<context>
    <name>dialogs::AppearanceDialog</name>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>Language and look</source>
        <translation>Langue et apparence</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>L&amp;ook</source>
        <translation>&amp;Apparence</translation>
    </message>
    <message>
        <source>Words of the robot and text from the controller stay as they are on the pendant.</source>
        <translation>Les mots du robot et les textes du contrôleur restent tels qu’ils sont sur le boîtier de programmation.</translation>
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
        <translation>Ancienne valeur</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nouvelle valeur</translation>
    </message>
    <message>
        <source>Apply — %1</source>
        <translation>Appliquer — %1</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>Ce qui sera écrit</translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s)</source>
        <translation>
            <numerusform>Écrire %n valeur</numerusform>
            <numerusform>Écrire %n valeurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write %n value(s) to %1</source>
        <translation>
            <numerusform>Écrire %n valeur sur %1</numerusform>
            <numerusform>Écrire %n valeurs sur %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Each is written once and read back. What does not read back as it was written stays here and is marked.</source>
        <translation>Chaque valeur est écrite une fois et relue. Celles dont la relecture diffère de l’écriture restent ici et sont marquées.</translation>
    </message>
</context>
<context>
    <name>dialogs::CompareDialog</name>
    <message>
        <source>Both are the same, byte for byte.</source>
        <translation>Les deux sont identiques, octet par octet.</translation>
    </message>
</context>
<context>
    <name>dialogs::ConnectionDialog</name>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Connect to a controller</source>
        <translation>Se connecter à un contrôleur</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Known controllers</source>
        <translation>Contrôleurs connus</translation>
    </message>
    <message>
        <source>CONTROLLERS</source>
        <translation>CONTRÔLEURS</translation>
    </message>
    <message>
        <source>Connecting only reads. HOLD: Pause key.</source>
        <translation>La connexion ne fait que lire. HOLD&#xa0;: touche Pause.</translation>
    </message>
    <message>
        <source>A motion limit must be a number above 0, and each side of the box must begin before it ends.</source>
        <translation>Une limite de mouvement doit être un nombre supérieur à 0, et chaque côté du volume limite doit commencer avant de finir.</translation>
    </message>
    <message>
        <source>There is another controller with the name “%1”.</source>
        <translation>Il existe un autre contrôleur nommé «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>New controller</source>
        <translation>Nouveau contrôleur</translation>
    </message>
</context>
<context>
    <name>dialogs::DiagnosisDialog</name>
    <message>
        <source>Diagnosis — %1</source>
        <translation>Diagnostic — %1</translation>
    </message>
    <message>
        <source>Copy diagnosis</source>
        <translation>Copier le diagnostic</translation>
    </message>
    <message>
        <source>The diagnosis is not finished yet.</source>
        <translation>Le diagnostic n’est pas encore terminé.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>It only reads. HOLD works meanwhile: Pause key.</source>
        <translation>Il ne fait que lire. HOLD reste possible&#xa0;: touche Pause.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copié</translation>
    </message>
</context>
<context>
    <name>dialogs::HelpDialog</name>
    <message>
        <source>Help — %1</source>
        <translation>Aide — %1</translation>
    </message>
    <message>
        <source>Search in this help</source>
        <translation>Rechercher dans cette aide</translation>
    </message>
    <message>
        <source>Nothing here has these words.</source>
        <translation>Rien ici ne contient ces mots.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Keys of this page</source>
        <translation>Touches de cette page</translation>
    </message>
    <message>
        <source>Keys everywhere</source>
        <translation>Touches valables partout</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>Without a connection: connect to the controller on the filled button</source>
        <translation>Sans connexion&#xa0;: se connecter au contrôleur du bouton plein</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Live: read within its last three turns.</source>
        <translation>En direct&#xa0;: lu au cours de ses trois derniers tours de lecture.</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>Périmé</translation>
    </message>
    <message>
        <source>Stale: read once, too long ago. The tool tip says when. It is not what the robot does now.</source>
        <translation>Périmé&#xa0;: lu une fois, il y a trop longtemps. L’infobulle indique quand. Ce n’est pas ce que le robot fait maintenant.</translation>
    </message>
    <message>
        <source>Unknown: not read on this connection. It is never shown as 0.</source>
        <translation>Inconnu&#xa0;: non lu sur cette connexion. N’est jamais affiché comme 0.</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Refusé</translation>
    </message>
    <message>
        <source>Refused: the controller does not tell it. The reason stands on the card or in the tool tip.</source>
        <translation>Refusé&#xa0;: le contrôleur ne le communique pas. Le motif figure sur la carte ou dans l’infobulle.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>on</translation>
    </message>
    <message>
        <source>A filled square: on, or 1.</source>
        <translation>Un carré plein&#xa0;: on, ou 1.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>off</translation>
    </message>
    <message>
        <source>A hollow square: off, or 0.</source>
        <translation>Un carré vide&#xa0;: off, ou 0.</translation>
    </message>
    <message>
        <source>held</source>
        <translation>en HOLD</translation>
    </message>
    <message>
        <source>An amber triangle: error, hold, something not allowed or to be looked at.</source>
        <translation>Un triangle ambre&#xa0;: erreur, HOLD, une chose non autorisée ou à vérifier.</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarme</translation>
    </message>
    <message>
        <source>A red square: an alarm.</source>
        <translation>Un carré rouge&#xa0;: une alarme.</translation>
    </message>
    <message>
        <source>What the signs mean</source>
        <translation>Signification des signes</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Exemple</translation>
    </message>
    <message>
        <source>An amber ground in a table: typed and staged, not sent yet. A red one: it reads back differently from what was written.</source>
        <translation>Un fond ambre dans un tableau&#xa0;: saisi et préparé, pas encore envoyé. Un fond rouge&#xa0;: la relecture diffère de ce qui a été écrit.</translation>
    </message>
</context>
<context>
    <name>dialogs::ImportDialog</name>
    <message>
        <source>Take over values — %1</source>
        <translation>Reprendre des valeurs — %1</translation>
    </message>
    <message numerus="yes">
        <source>Stage %n value(s)</source>
        <translation>
            <numerusform>Préparer %n valeur</numerusform>
            <numerusform>Préparer %n valeurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) would change</source>
        <translation>
            <numerusform>%n valeur changerait</numerusform>
            <numerusform>%n valeurs changeraient</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n value(s) are there already. Staging sends nothing to the controller.</source>
        <translation>
            <numerusform>%n valeur est déjà présente. La préparation n’envoie rien au contrôleur.</numerusform>
            <numerusform>%n valeurs sont déjà présentes. La préparation n’envoie rien au contrôleur.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) cannot be read, so nothing is taken over:</source>
        <translation>
            <numerusform>%n ligne est illisible, donc rien n’est repris&#xa0;:</numerusform>
            <numerusform>%n lignes sont illisibles, donc rien n’est repris&#xa0;:</numerusform>
        </translation>
    </message>
    <message>
        <source>Lines that cannot be read</source>
        <translation>Lignes illisibles</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Ce qui est incorrect</translation>
    </message>
    <message>
        <source>Values that would change</source>
        <translation>Valeurs qui changeraient</translation>
    </message>
    <message>
        <source>Variable</source>
        <translation>Variable</translation>
    </message>
    <message>
        <source>Old value</source>
        <translation>Ancienne valeur</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>Nouvelle valeur</translation>
    </message>
</context>
<context>
    <name>dialogs::IoWriteDialog</name>
    <message>
        <source>Write %1 — %2</source>
        <translation>Écrire %1 — %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Maintenant</translation>
    </message>
    <message>
        <source>Will be</source>
        <translation>Sera</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The eight signals #%1 to #%2 travel together: all of them are written as they stand here.</source>
        <translation>Les huit signaux #%1 à #%2 sont transmis ensemble&#xa0;: tous sont écrits tels qu’ils figurent ici.</translation>
    </message>
    <message>
        <source>The group is being read…</source>
        <translation>Lecture du groupe en cours…</translation>
    </message>
    <message>
        <source>Written once, then read back.</source>
        <translation>Écrit une fois, puis relu.</translation>
    </message>
    <message>
        <source>Another of the eight has changed meanwhile. Nothing was sent: look again.</source>
        <translation>Un autre des huit signaux a changé entre-temps. Rien n’a été envoyé&#xa0;: vérifier à nouveau.</translation>
    </message>
    <message>
        <source>Being written…</source>
        <translation>Écriture en cours…</translation>
    </message>
    <message>
        <source>Written, and read back as it was written.</source>
        <translation>Écrit, et relu tel qu’écrit.</translation>
    </message>
    <message>
        <source>Accepted, but another value was read back: %1. Something else writes these signals.</source>
        <translation>Accepté, mais une autre valeur a été relue&#xa0;: %1. Autre chose écrit ces signaux.</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Mettre à ON</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Mettre à OFF</translation>
    </message>
</context>
<context>
    <name>dialogs::JobEditor</name>
    <message>
        <source>Edit “%1”</source>
        <translation>Modifier «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Text of the file</source>
        <translation>Texte du fichier</translation>
    </message>
    <message>
        <source>Compare and send…</source>
        <translation>Comparer et envoyer…</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding lacks a character of this text.</source>
        <translation>Un caractère de ce texte n’existe pas dans l’encodage du contrôleur.</translation>
    </message>
</context>
<context>
    <name>dialogs::LadderView</name>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échoué</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>non atteint</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Pendesk %1, diagnosis of %2 (%3)</source>
        <translation>Pendesk %1, diagnostic de %2 (%3)</translation>
    </message>
</context>
<context>
    <name>dialogs::MotionForm</name>
    <message>
        <source>The tool point must stay in this box (base frame, mm)</source>
        <translation>Le point outil doit rester dans ce volume limite (repère base, mm)</translation>
    </message>
    <message>
        <source>User and tool frames were checked on this robot</source>
        <translation>Les repères utilisateur et outil ont été vérifiés sur ce robot</translation>
    </message>
    <message>
        <source>Speed, mm/s</source>
        <translation>Vitesse, mm/s</translation>
    </message>
    <message>
        <source>Rotation speed, °/s</source>
        <translation>Vitesse de rotation, °/s</translation>
    </message>
    <message>
        <source>Joint speed, %</source>
        <translation>Vitesse articulaire, %</translation>
    </message>
    <message>
        <source>Jog step, mm</source>
        <translation>Pas manuel, mm</translation>
    </message>
    <message>
        <source>Jog step, °</source>
        <translation>Pas manuel, °</translation>
    </message>
    <message>
        <source>Jog step, pulses</source>
        <translation>Pas manuel, impulsions</translation>
    </message>
    <message>
        <source>Descriptions disagree which code means the user and which the tool frame. Tick this only after a small move in both was watched at the robot.</source>
        <translation>Les descriptions se contredisent sur le code qui désigne le repère utilisateur et celui qui désigne le repère outil. Ne cocher qu’après avoir observé au robot un petit mouvement dans les deux.</translation>
    </message>
    <message>
        <source>%1, as the program</source>
        <translation>%1, valeur du programme</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>%1 minimum</translation>
    </message>
    <message>
        <source>Most %1</source>
        <translation>%1 maximum</translation>
    </message>
    <message>
        <source>%1 from, to</source>
        <translation>%1 de, à</translation>
    </message>
</context>
<context>
    <name>dialogs::MoveSheet</name>
    <message>
        <source>%1 pulses</source>
        <translation>%1 impulsions</translation>
    </message>
    <message>
        <source>%1 mm · %2°</source>
        <translation>%1 mm · %2°</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Stop: HOLD</source>
        <translation>Arrêter&#xa0;: HOLD</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Move at %1</source>
        <translation>Déplacer sur %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>Groupe d’axes</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Volume limite</translation>
    </message>
    <message>
        <source>Stored points near the target</source>
        <translation>Points enregistrés proches de la cible</translation>
    </message>
    <message>
        <source>A long move, or one that nobody can measure: type %1</source>
        <translation>Mouvement long ou non mesurable&#xa0;: saisir %1</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>Au clavier&#xa0;: saisir %1, puis F9</translation>
    </message>
    <message>
        <source>HOLD stays on until it is released</source>
        <translation>HOLD reste actif jusqu’à son annulation</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>Le robot va se déplacer</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>cannot be foretold in this frame</source>
        <translation>imprévisible dans ce repère</translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation>environ %1 s</translation>
    </message>
    <message>
        <source>not known: a percentage of joint speed</source>
        <translation>inconnue&#xa0;: pourcentage de la vitesse articulaire</translation>
    </message>
    <message>
        <source>not known: the target is in pulses</source>
        <translation>inconnue&#xa0;: la cible est en impulsions</translation>
    </message>
    <message>
        <source>%1 mm and %2° between the ends; a joint move does not go straight</source>
        <translation>%1 mm et %2° entre les extrémités&#xa0;; un mouvement articulaire n’est pas rectiligne</translation>
    </message>
    <message>
        <source>%1 mm straight, turning %2°</source>
        <translation>%1 mm en ligne droite, rotation de %2°</translation>
    </message>
    <message>
        <source>none is set for this controller</source>
        <translation>aucun n’est défini pour ce contrôleur</translation>
    </message>
    <message>
        <source>the whole way is inside</source>
        <translation>tout le trajet est à l’intérieur</translation>
    </message>
    <message>
        <source>both ends are inside; the way between is not known</source>
        <translation>les deux extrémités sont à l’intérieur&#xa0;; le trajet entre elles est inconnu</translation>
    </message>
    <message>
        <source>%1, at most %2 %</source>
        <translation>%1, au plus %2 %</translation>
    </message>
    <message>
        <source>%1, at most %2 mm/s</source>
        <translation>%1, au plus %2 mm/s</translation>
    </message>
    <message>
        <source>%1, at most %2 °/s</source>
        <translation>%1, au plus %2 °/s</translation>
    </message>
    <message>
        <source>cannot be compared</source>
        <translation>non comparable</translation>
    </message>
    <message>
        <source>%1 at %2 mm</source>
        <translation>%1 à %2 mm</translation>
    </message>
    <message>
        <source>none in the base frame was read</source>
        <translation>aucun point lu dans le repère base</translation>
    </message>
    <message>
        <source>The robot is no longer where this move begins: close, and rehearse again.</source>
        <translation>Le robot n’est plus à l’endroit où commence ce mouvement&#xa0;: fermer, puis refaire le contrôle préalable.</translation>
    </message>
    <message>
        <source>Not sent: the place could not be read.</source>
        <translation>Non envoyé&#xa0;: la position n’a pas pu être lue.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>a place that was not read</source>
        <translation>une position qui n’a pas été lue</translation>
    </message>
    <message>
        <source>Under way: %1</source>
        <translation>En cours&#xa0;: %1</translation>
    </message>
    <message>
        <source>Move sent…</source>
        <translation>Mouvement envoyé…</translation>
    </message>
    <message>
        <source>Arrived: %1</source>
        <translation>Arrivé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Stopped at %1. That is not the target.</source>
        <translation>Arrêté à %1. Ce n’est pas la cible.</translation>
    </message>
    <message>
        <source>At rest at %1. Whether that is the target cannot be told in this frame.</source>
        <translation>Immobile à %1. Impossible de dire dans ce repère si c’est la cible.</translation>
    </message>
    <message>
        <source>No answer to the move: whether it was begun is unknown. It was sent once. Look at the robot.</source>
        <translation>Pas de réponse au mouvement&#xa0;: on ignore s’il a commencé. Il a été envoyé une fois. Observer le robot.</translation>
    </message>
    <message>
        <source>The outcome is unknown: communication was lost, or it does not come to rest. Look at the robot.</source>
        <translation>Le résultat est inconnu&#xa0;: la communication a été perdue, ou le robot ne s’immobilise pas. Observer le robot.</translation>
    </message>
</context>
<context>
    <name>dialogs::NumberingDialog</name>
    <message>
        <source>Variable numbering — %1</source>
        <translation>Numérotation des variables — %1</translation>
    </message>
    <message>
        <source>Number of the variable</source>
        <translation>Numéro de la variable</translation>
    </message>
    <message>
        <source>Value on the pendant</source>
        <translation>Valeur sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>pas encore lu</translation>
    </message>
    <message>
        <source>reads on the pendant</source>
        <translation>affiche sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Keep the result</source>
        <translation>Conserver le résultat</translation>
    </message>
    <message>
        <source>Which number is which?</source>
        <translation>Quel numéro correspond à quoi&#xa0;?</translation>
    </message>
    <message>
        <source>Parameter RS022 decides whether B000 is number 0 or number 1 on the network. Until that is known, a write could hit the neighbour, so none is sent. Read two variables on the pendant (main menu, VARIABLE, BYTE) and enter what you see. This test only reads.</source>
        <translation>Le paramètre RS022 détermine si B000 porte le numéro 0 ou le numéro 1 sur le réseau. Tant que cela n’est pas connu, une écriture pourrait atteindre la variable voisine&#xa0;; aucune n’est donc envoyée. Lire deux variables sur le boîtier de programmation (menu principal, VARIABLE, BYTE) et saisir les valeurs affichées. Ce test ne fait que lire.</translation>
    </message>
    <message>
        <source>The variables could not be read: %1.</source>
        <translation>Les variables n’ont pas pu être lues&#xa0;: %1.</translation>
    </message>
    <message>
        <source>All B variables hold the same value, which proves nothing: let a job or the pendant set B010 to 1 and B011 to 2, then open this test again.</source>
        <translation>Toutes les variables B ont la même valeur, ce qui ne prouve rien&#xa0;: mettre B010 à 1 et B011 à 2 par un job ou sur le boîtier de programmation, puis ouvrir à nouveau ce test.</translation>
    </message>
    <message>
        <source>These two tell the numberings apart.</source>
        <translation>Ces deux variables permettent de distinguer les numérotations.</translation>
    </message>
    <message>
        <source>Verified: number 0 on the network is B000.</source>
        <translation>Vérifié&#xa0;: le numéro 0 sur le réseau est B000.</translation>
    </message>
    <message>
        <source>Verified, shifted: number 1 on the network is B000.</source>
        <translation>Vérifié, décalé&#xa0;: le numéro 1 sur le réseau est B000.</translation>
    </message>
    <message>
        <source>Both numberings fit these values: choose variables whose neighbours hold other values.</source>
        <translation>Les deux numérotations correspondent à ces valeurs&#xa0;: choisir des variables dont les voisines ont d’autres valeurs.</translation>
    </message>
    <message>
        <source>Neither numbering fits: read the values again, they may have changed.</source>
        <translation>Aucune numérotation ne correspond&#xa0;: relire les valeurs, elles ont peut-être changé.</translation>
    </message>
</context>
<context>
    <name>dialogs::OverwriteDialog</name>
    <message numerus="yes">
        <source>For the remaining %n file(s) too</source>
        <translation>
            <numerusform>Pour le %n fichier restant également</numerusform>
            <numerusform>Pour les %n fichiers restants également</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” exists</source>
        <translation>«&#xa0;%1&#xa0;» existe</translation>
    </message>
    <message>
        <source>There is a file “%1” %2 already.</source>
        <translation>Il existe déjà un fichier «&#xa0;%1&#xa0;» %2.</translation>
    </message>
    <message>
        <source>&amp;Compare…</source>
        <translation>&amp;Comparer…</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>&amp;Keep both</source>
        <translation>Conserver les &amp;deux</translation>
    </message>
    <message>
        <source>&amp;Skip</source>
        <translation>&amp;Ignorer</translation>
    </message>
</context>
<context>
    <name>dialogs::PasscodeDialog</name>
    <message>
        <source>The passcode guards against mistakes, not against attackers: whoever can change this user&apos;s files can remove it.</source>
        <translation>Le code d’accès protège contre les erreurs, pas contre les attaques&#xa0;: quiconque peut modifier les fichiers de cet utilisateur peut le supprimer.</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>Niveau d’accès&#xa0;: %1</translation>
    </message>
    <message>
        <source>Passcode</source>
        <translation>Code d’accès</translation>
    </message>
    <message>
        <source>That is not the passcode.</source>
        <translation>Ce n’est pas le code d’accès.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
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
        <translation>Type</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Préparer</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>Repère utilisateur</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>Configuration étendue</translation>
    </message>
    <message>
        <source>Take the present position of R1 (base frame)</source>
        <translation>Reprendre la position actuelle de R1 (repère base)</translation>
    </message>
    <message>
        <source>Take R1 in pulses</source>
        <translation>Reprendre R1 en impulsions</translation>
    </message>
    <message>
        <source>Take the present position of B1 (base frame)</source>
        <translation>Reprendre la position actuelle de B1 (repère base)</translation>
    </message>
    <message>
        <source>Take B1 in pulses</source>
        <translation>Reprendre B1 en impulsions</translation>
    </message>
    <message>
        <source>Take the present position of S1</source>
        <translation>Reprendre la position actuelle de S1</translation>
    </message>
    <message>
        <source>live: %1</source>
        <translation>en direct&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>A user-frame position needs a user frame from 1 to 63.</source>
        <translation>Une position en repère utilisateur exige un repère utilisateur de 1 à 63.</translation>
    </message>
    <message>
        <source>Sources disagree which code means user and which means tool frame: check on the pendant before a job uses this position.</source>
        <translation>Les sources se contredisent sur le code qui désigne le repère utilisateur et celui qui désigne le repère outil&#xa0;: vérifier sur le boîtier de programmation avant qu’un job utilise cette position.</translation>
    </message>
    <message>
        <source>The position is being read…</source>
        <translation>Lecture de la position en cours…</translation>
    </message>
    <message>
        <source>The position could not be read: %1.</source>
        <translation>La position n’a pas pu être lue&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>dialogs::ProfileForm</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Host name or address</source>
        <translation>Nom d’hôte ou adresse</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Text encoding</source>
        <translation>Encodage du texte</translation>
    </message>
    <message>
        <source>Variable numbering</source>
        <translation>Numérotation des variables</translation>
    </message>
    <message>
        <source>B000 is number 0 on the wire</source>
        <translation>B000 porte le numéro 0 sur le réseau</translation>
    </message>
    <message>
        <source>B000 is number 1 on the wire</source>
        <translation>B000 porte le numéro 1 sur le réseau</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Port des fichiers</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>Délai de lecture</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>Délai des fichiers</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>Délai du servo</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>Répétitions d’une lecture</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>Requêtes simultanées en attente</translation>
    </message>
    <message>
        <source>Requests a second, at most</source>
        <translation>Requêtes par seconde, au plus</translation>
    </message>
    <message>
        <source>Jog and move, at most</source>
        <translation>Déplacement manuel et mouvement, au plus</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>De %1 à %2</translation>
    </message>
</context>
<context>
    <name>dialogs::ReadinessSheet</name>
    <message>
        <source>Readiness — %1</source>
        <translation>Disponibilité — %1</translation>
    </message>
    <message>
        <source>What %1 allows now</source>
        <translation>Ce que %1 permet maintenant</translation>
    </message>
    <message>
        <source>Readiness</source>
        <translation>Disponibilité</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the readiness and a diagnosis</source>
        <translation>Copier la disponibilité et un diagnostic</translation>
    </message>
    <message>
        <source>As text for support, with a diagnosis of the link, which takes a moment.</source>
        <translation>Sous forme de texte pour l’assistance, avec un diagnostic de la liaison, qui prend un instant.</translation>
    </message>
    <message>
        <source>Test numbering…</source>
        <translation>Tester la numérotation…</translation>
    </message>
    <message>
        <source>It needs a link to the controller.</source>
        <translation>Il faut une liaison avec le contrôleur.</translation>
    </message>
    <message>
        <source>Communication lost at %1: what is hatched was read before.</source>
        <translation>Communication perdue à %1&#xa0;: ce qui est hachuré a été lu avant.</translation>
    </message>
    <message>
        <source>%1 has not answered yet.</source>
        <translation>%1 n’a pas encore répondu.</translation>
    </message>
    <message>
        <source>Not connected: nothing is read.</source>
        <translation>Non connecté&#xa0;: rien n’est lu.</translation>
    </message>
    <message>
        <source>The status was not read just now.</source>
        <translation>L’état n’a pas été lu récemment.</translation>
    </message>
    <message>
        <source>It is read live and changes nothing. HOLD works meanwhile: Pause key.</source>
        <translation>La lecture est en direct et ne modifie rien. HOLD reste possible&#xa0;: touche Pause.</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copié</translation>
    </message>
</context>
<context>
    <name>dialogs::RestoreDialog</name>
    <message>
        <source>Put that file back</source>
        <translation>Remettre ce fichier en place</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Restore %1 from %2</source>
        <translation>Restaurer %1 depuis %2</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>Ce qui serait fait</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>What is done</source>
        <translation>Ce qui est fait</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>+ new: it is sent</source>
        <translation>+ nouveau&#xa0;: il est envoyé</translation>
    </message>
    <message>
        <source>≠ changed: it is replaced</source>
        <translation>≠ modifié&#xa0;: il est remplacé</translation>
    </message>
    <message>
        <source>= same: left alone</source>
        <translation>= identique&#xa0;: laissé tel quel</translation>
    </message>
    <message>
        <source>▲ not allowed: left alone</source>
        <translation>▲ non autorisé&#xa0;: laissé tel quel</translation>
    </message>
    <message numerus="yes">
        <source>Back up, then restore %n file(s)</source>
        <translation>
            <numerusform>Sauvegarder, puis restaurer %n fichier</numerusform>
            <numerusform>Sauvegarder, puis restaurer %n fichiers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) are the same and not listed.</source>
        <translation>
            <numerusform>%n fichier est identique et n’est pas listé.</numerusform>
            <numerusform>%n fichiers sont identiques et ne sont pas listés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Sending file %1 of %2…</source>
        <translation>Envoi du fichier %1 sur %2…</translation>
    </message>
    <message>
        <source>Fresh backup: file %1 of %2…</source>
        <translation>Nouvelle sauvegarde&#xa0;: fichier %1 sur %2…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored and read back.</source>
        <translation>
            <numerusform>%n fichier a été restauré et relu.</numerusform>
            <numerusform>%n fichiers ont été restaurés et relus.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) were restored before that.</source>
        <translation>
            <numerusform>%n fichier a été restauré auparavant.</numerusform>
            <numerusform>%n fichiers ont été restaurés auparavant.</numerusform>
        </translation>
    </message>
    <message>
        <source>It was cancelled.</source>
        <translation>L’opération a été annulée.</translation>
    </message>
    <message>
        <source>Stopped at %1.</source>
        <translation>Arrêté à %1.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>Rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>The file is as it was before.</source>
        <translation>Le fichier est comme avant.</translation>
    </message>
    <message>
        <source>▲ The file could not be put back. Look at the controller.</source>
        <translation>▲ Le fichier n’a pas pu être remis en place. Vérifier sur le contrôleur.</translation>
    </message>
    <message>
        <source>A fresh backup of %1 is made first. Then the files below are sent one by one and read back. A refused file is left out; it stops at any other error.</source>
        <translation>Une nouvelle sauvegarde de %1 est d’abord faite. Puis les fichiers ci-dessous sont envoyés un par un et relus. Un fichier refusé est omis&#xa0;; toute autre erreur arrête l’opération.</translation>
    </message>
    <message>
        <source>%1: the backup is of %2, the controller is %3.</source>
        <translation>%1&#xa0;: la sauvegarde est de %2, le contrôleur est %3.</translation>
    </message>
    <message>
        <source>This is the backup of another robot: nothing of it is sent.</source>
        <translation>C’est la sauvegarde d’un autre robot&#xa0;: rien n’en est envoyé.</translation>
    </message>
    <message>
        <source>The controller refused %1; the other files were sent.</source>
        <translation>Le contrôleur a refusé %1&#xa0;; les autres fichiers ont été envoyés.</translation>
    </message>
</context>
<context>
    <name>dialogs::SignalPicker</name>
    <message>
        <source>Add a signal</source>
        <translation>Ajouter un signal</translation>
    </message>
    <message>
        <source>For example: R1 torque, B005, #00010, M012</source>
        <translation>Par exemple&#xa0;: R1 couple, B005, #00010, M012</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>dialogs::StartSheet</name>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Start at %1</source>
        <translation>Démarrer sur %1</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>À partir de la ligne</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Correction de vitesse</translation>
    </message>
    <message>
        <source>HOLD: Pause key</source>
        <translation>HOLD&#xa0;: touche Pause</translation>
    </message>
    <message>
        <source>The robot will move</source>
        <translation>Le robot va se déplacer</translation>
    </message>
    <message>
        <source>With the keyboard: type %1, then F9</source>
        <translation>Au clavier&#xa0;: saisir %1, puis F9</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Start sent…</source>
        <translation>Démarrage envoyé…</translation>
    </message>
    <message>
        <source>Accepted. Waiting for RUN…</source>
        <translation>Accepté. Attente de RUN…</translation>
    </message>
    <message>
        <source>The start was accepted, but no RUN was seen for 3 s. Usual causes: the job was so short that it has ended, it waits for a condition of the cell, or the pendant shows a question. Look at the pendant.</source>
        <translation>Le démarrage a été accepté, mais aucun RUN n’a été vu pendant 3 s. Causes habituelles&#xa0;: le job était si court qu’il est déjà terminé, il attend une condition de la cellule, ou le boîtier de programmation affiche une question. Consulter le boîtier de programmation.</translation>
    </message>
    <message>
        <source>No answer to the start: it may or may not have happened. Reading the status…</source>
        <translation>Pas de réponse au démarrage&#xa0;: il a pu avoir lieu ou non. Lecture de l’état…</translation>
    </message>
    <message>
        <source>No answer to the start, and none to the status: whether the robot runs is unknown. Look at it.</source>
        <translation>Pas de réponse au démarrage ni à la lecture de l’état&#xa0;: on ignore si le robot est en marche. L’observer.</translation>
    </message>
    <message>
        <source>No answer to the start, but a status that was read afterwards said RUN. It was sent once.</source>
        <translation>Pas de réponse au démarrage, mais un état lu ensuite indiquait RUN. L’ordre a été envoyé une fois.</translation>
    </message>
    <message>
        <source>No answer to the start, and a status that was read afterwards said no RUN. Look at the robot before you start again.</source>
        <translation>Pas de réponse au démarrage, et un état lu ensuite n’indiquait pas RUN. Regarder le robot avant de redémarrer.</translation>
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
        <translation>Conditions</translation>
    </message>
    <message>
        <source>What must be the case</source>
        <translation>Ce qui doit être rempli</translation>
    </message>
</context>
<context>
    <name>files::Identity</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Hôte</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Robots and axes</source>
        <translation>Robots et axes</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>Number of variables</source>
        <translation>Nombre de variables</translation>
    </message>
</context>
<context>
    <name>files::Restore</name>
    <message>
        <source>It is not in the backup.</source>
        <translation>Il n’est pas dans la sauvegarde.</translation>
    </message>
    <message>
        <source>What the controller has could not be read.</source>
        <translation>Ce que contient le contrôleur n’a pas pu être lu.</translation>
    </message>
    <message>
        <source>In the backup it is not as it was written.</source>
        <translation>Dans la sauvegarde, il n’est pas tel qu’il a été écrit.</translation>
    </message>
    <message>
        <source>It belongs to this one controller, or only tells what happened: it is never sent.</source>
        <translation>Il appartient à ce seul contrôleur, ou indique seulement ce qui s’est passé&#xa0;: il n’est jamais envoyé.</translation>
    </message>
    <message>
        <source>It comes from another robot.</source>
        <translation>Il provient d’un autre robot.</translation>
    </message>
    <message>
        <source>It changes how the robot moves, or what protects people: look at the differences and choose it.</source>
        <translation>Il change la façon dont le robot se déplace, ou ce qui protège les personnes&#xa0;: regarder les différences et le choisir.</translation>
    </message>
</context>
<context>
    <name>files::Verify</name>
    <message>
        <source>This is no backup: %1 is missing or of another kind.</source>
        <translation>Ce n’est pas une sauvegarde&#xa0;: %1 est absent ou d’un autre type.</translation>
    </message>
    <message>
        <source>%1 is not as it was written.</source>
        <translation>%1 n’est pas tel qu’il a été écrit.</translation>
    </message>
    <message>
        <source>%1 was changed.</source>
        <translation>%1 a été modifié.</translation>
    </message>
    <message>
        <source>%1 is missing.</source>
        <translation>%1 est absent.</translation>
    </message>
    <message>
        <source>%1 does not belong to the backup.</source>
        <translation>%1 n’appartient pas à la sauvegarde.</translation>
    </message>
</context>
<context>
    <name>inform::Check</name>
    <message>
        <source>The file is empty.</source>
        <translation>Le fichier est vide.</translation>
    </message>
    <message>
        <source>HSES cannot carry it.</source>
        <translation>HSES ne peut pas le transmettre.</translation>
    </message>
    <message>
        <source>“%1” is no type of file that can be sent.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un type de fichier qui peut être envoyé.</translation>
    </message>
    <message>
        <source>Controllers take JBI, JBR, CND, DAT, PRM and LST.</source>
        <translation>Les contrôleurs acceptent JBI, JBR, CND, DAT, PRM et LST.</translation>
    </message>
    <message>
        <source>The type of the file is written in small letters.</source>
        <translation>Le type du fichier est écrit en minuscules.</translation>
    </message>
    <message>
        <source>Controllers write it in capitals.</source>
        <translation>Les contrôleurs l’écrivent en majuscules.</translation>
    </message>
    <message>
        <source>The header names the job “%1”.</source>
        <translation>L’en-tête nomme le job «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>The name in the header counts: that job would be written.</source>
        <translation>Le nom dans l’en-tête compte&#xa0;: c’est ce job qui serait écrit.</translation>
    </message>
    <message>
        <source>The job is being executed.</source>
        <translation>Le job est en cours d’exécution.</translation>
    </message>
    <message>
        <source>A running job cannot be replaced.</source>
        <translation>Un job en marche ne peut pas être remplacé.</translation>
    </message>
    <message>
        <source>All names in the controller become those in this file.</source>
        <translation>Tous les noms du contrôleur deviennent ceux de ce fichier.</translation>
    </message>
    <message>
        <source>Back them up first.</source>
        <translation>Les sauvegarder d’abord.</translation>
    </message>
    <message>
        <source>The file begins with a byte order mark.</source>
        <translation>Le fichier commence par une marque d’ordre des octets.</translation>
    </message>
    <message>
        <source>Controllers know no such mark: save the file without it.</source>
        <translation>Les contrôleurs ignorent cette marque&#xa0;: enregistrer le fichier sans elle.</translation>
    </message>
    <message>
        <source>The file is UTF-16 text.</source>
        <translation>Le fichier est du texte UTF-16.</translation>
    </message>
    <message>
        <source>Controllers take one byte for a letter.</source>
        <translation>Les contrôleurs utilisent un octet par lettre.</translation>
    </message>
    <message>
        <source>The lines end in CR alone.</source>
        <translation>Les lignes se terminent par CR seul.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (pendant 3200).</source>
        <translation>Les lignes se terminent par CR LF&#xa0;; le contrôleur ne trouve ni NOP ni END (boîtier 3200).</translation>
    </message>
    <message>
        <source>Lines end in LF alone.</source>
        <translation>Les lignes se terminent par LF seul.</translation>
    </message>
    <message>
        <source>Lines end in CR LF; the controller finds neither NOP nor END (0x5130, pendant 3200).</source>
        <translation>Les lignes se terminent par CR LF&#xa0;; le contrôleur ne trouve ni NOP ni END (0x5130, boîtier 3200).</translation>
    </message>
    <message>
        <source>Lines end in CR LF; a controller may read such a file as empty.</source>
        <translation>Les lignes se terminent par CR LF&#xa0;; un contrôleur peut lire un tel fichier comme vide.</translation>
    </message>
    <message>
        <source>The last line does not end.</source>
        <translation>La dernière ligne n’a pas de fin de ligne.</translation>
    </message>
    <message>
        <source>Controllers end each line in CR LF.</source>
        <translation>Les contrôleurs terminent chaque ligne par CR LF.</translation>
    </message>
    <message>
        <source>There is a Ctrl-Z at the end.</source>
        <translation>Il y a un Ctrl-Z à la fin.</translation>
    </message>
    <message>
        <source>It stands behind END, which must be last (0x5130).</source>
        <translation>Il se trouve après END, qui doit être en dernier (0x5130).</translation>
    </message>
    <message>
        <source>There is a control character.</source>
        <translation>Il y a un caractère de contrôle.</translation>
    </message>
    <message>
        <source>No line of a job may have one.</source>
        <translation>Aucune ligne d’un job ne peut en avoir.</translation>
    </message>
    <message>
        <source>This is no job: it does not have the line /JOB.</source>
        <translation>Ce n’est pas un job&#xa0;: la ligne /JOB est absente.</translation>
    </message>
    <message>
        <source>A job begins with it (0x5310).</source>
        <translation>Un job commence par elle (0x5310).</translation>
    </message>
    <message>
        <source>The file holds more than one job.</source>
        <translation>Le fichier contient plus d’un job.</translation>
    </message>
    <message>
        <source>Only the first one was looked at.</source>
        <translation>Seul le premier a été examiné.</translation>
    </message>
    <message>
        <source>“%1” is no name for a job.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nom de job.</translation>
    </message>
    <message>
        <source>A name has 1 to 32 bytes, no blanks and none of the signs that names of files may not have (0x4190).</source>
        <translation>Un nom a de 1 à 32 octets, sans espace ni aucun des signes interdits dans les noms de fichiers (0x4190).</translation>
    </message>
    <message>
        <source>There is text that belongs to no section.</source>
        <translation>Il y a du texte qui n’appartient à aucune section.</translation>
    </message>
    <message>
        <source>It is no INFORM (0x5310).</source>
        <translation>Ce n’est pas de l’INFORM (0x5310).</translation>
    </message>
    <message>
        <source>%1 is no known pseudo instruction.</source>
        <translation>%1 n’est pas une pseudo-instruction connue.</translation>
    </message>
    <message>
        <source>A controller that does not know it refuses the file (0x5340).</source>
        <translation>Un contrôleur qui ne la connaît pas refuse le fichier (0x5340).</translation>
    </message>
    <message>
        <source>The comment of the job is longer than 32 bytes.</source>
        <translation>Le commentaire du job dépasse 32 octets.</translation>
    </message>
    <message>
        <source>Controllers cut it or refuse it.</source>
        <translation>Les contrôleurs le coupent ou le refusent.</translation>
    </message>
    <message>
        <source>A frame is given, and the attribute RJ is missing.</source>
        <translation>Un repère est indiqué, et l’attribut RJ est absent.</translation>
    </message>
    <message>
        <source>Only relative jobs have a frame (0x4490).</source>
        <translation>Seuls les jobs relatifs ont un repère (0x4490).</translation>
    </message>
    <message>
        <source>The job is relative, and no frame is given.</source>
        <translation>Le job est relatif, et aucun repère n’est indiqué.</translation>
    </message>
    <message>
        <source>A relative job names its frame (0x3390).</source>
        <translation>Un job relatif nomme son repère (0x3390).</translation>
    </message>
    <message>
        <source>There are positions, and no ///NPOS that counts them.</source>
        <translation>Il y a des positions, et pas de ///NPOS qui les compte.</translation>
    </message>
    <message>
        <source>The controller compares them (0x5180).</source>
        <translation>Le contrôleur les compare (0x5180).</translation>
    </message>
    <message>
        <source>///NPOS does not count the positions of each kind: %1 (kind, said, found).</source>
        <translation>///NPOS ne compte pas les positions de chaque type&#xa0;: %1 (type, indiqué, trouvé).</translation>
    </message>
    <message>
        <source>There is text among the positions that is none.</source>
        <translation>Il y a parmi les positions du texte qui n’en est pas une.</translation>
    </message>
    <message>
        <source>Every line of //POS is a position or a pseudo instruction (0x5120).</source>
        <translation>Chaque ligne de //POS est une position ou une pseudo-instruction (0x5120).</translation>
    </message>
    <message>
        <source>%1 is there twice.</source>
        <translation>%1 figure deux fois.</translation>
    </message>
    <message>
        <source>Each position has one entry (0x5120).</source>
        <translation>Chaque position a une entrée (0x5120).</translation>
    </message>
    <message>
        <source>%1 is named by no line.</source>
        <translation>%1 n’est nommé par aucune ligne.</translation>
    </message>
    <message>
        <source>Each taught point belongs to one instruction (pendant 3190).</source>
        <translation>Chaque point appris appartient à une instruction (boîtier 3190).</translation>
    </message>
    <message>
        <source>%1 has no entry among the positions.</source>
        <translation>%1 n’a pas d’entrée parmi les positions.</translation>
    </message>
    <message>
        <source>The robot would not know where to go (0x4130).</source>
        <translation>Le robot ne saurait pas où aller (0x4130).</translation>
    </message>
    <message>
        <source>%1 is named in two places.</source>
        <translation>%1 est nommé à deux endroits.</translation>
    </message>
    <message>
        <source>Controllers give each place a point of its own.</source>
        <translation>Les contrôleurs donnent à chaque endroit son propre point.</translation>
    </message>
    <message>
        <source>The number of values does not fit the axes: %1 (position, values).</source>
        <translation>Le nombre de valeurs ne correspond pas aux axes&#xa0;: %1 (position, valeurs).</translation>
    </message>
    <message>
        <source>A robot has 6 or 7 axes, a base 1 to 3, a station 1 to 6 (0x5180).</source>
        <translation>Un robot a 6 ou 7 axes, une base 1 à 3, une station 1 à 6 (0x5180).</translation>
    </message>
    <message>
        <source>%1 has a value that is no number.</source>
        <translation>%1 a une valeur qui n’est pas un nombre.</translation>
    </message>
    <message>
        <source>The controller cannot read it (0x5120).</source>
        <translation>Le contrôleur ne peut pas la lire (0x5120).</translation>
    </message>
    <message>
        <source>The line ///PULSE, ///RECTAN or ///ANGLE before %1 does not fit its ///POSTYPE.</source>
        <translation>La ligne ///PULSE, ///RECTAN ou ///ANGLE avant %1 ne correspond pas à son ///POSTYPE.</translation>
    </message>
    <message>
        <source>PULSE goes with ///PULSE, ANGLE with ///ANGLE, the others with ///RECTAN (0x5120).</source>
        <translation>PULSE va avec ///PULSE, ANGLE avec ///ANGLE, les autres avec ///RECTAN (0x5120).</translation>
    </message>
    <message>
        <source>%1 is in pulses, and the job is relative.</source>
        <translation>%1 est en impulsions, et le job est relatif.</translation>
    </message>
    <message>
        <source>The points of a relative job stand in its frame.</source>
        <translation>Les points d’un job relatif sont exprimés dans son repère.</translation>
    </message>
    <message>
        <source>There are taught points (%1), and the job has no control group.</source>
        <translation>Il y a des points appris (%1), et le job n’a pas de groupe d’axes.</translation>
    </message>
    <message>
        <source>A job without a group cannot move (0x5430).</source>
        <translation>Un job sans groupe ne peut rien déplacer (0x5430).</translation>
    </message>
    <message>
        <source>There are %1 points, and no control group of the job has such axes.</source>
        <translation>Il y a des points %1, et aucun groupe d’axes du job n’a de tels axes.</translation>
    </message>
    <message>
        <source>C needs a robot, BC a base, EC a station among the groups (0x3370).</source>
        <translation>C exige un robot, BC une base, EC une station parmi les groupes (0x3370).</translation>
    </message>
    <message>
        <source>The first instruction is not NOP.</source>
        <translation>La première instruction n’est pas NOP.</translation>
    </message>
    <message>
        <source>Every job begins with NOP (0x5130, pendant 3200).</source>
        <translation>Chaque job commence par NOP (0x5130, boîtier 3200).</translation>
    </message>
    <message>
        <source>The last instruction is not END.</source>
        <translation>La dernière instruction n’est pas END.</translation>
    </message>
    <message>
        <source>Every job ends with END (0x5130, pendant 3200).</source>
        <translation>Chaque job se termine par END (0x5130, boîtier 3200).</translation>
    </message>
    <message>
        <source>There is an END before the last line.</source>
        <translation>Il y a un END avant la dernière ligne.</translation>
    </message>
    <message>
        <source>What follows it is no job (0x5130).</source>
        <translation>Ce qui le suit n’est pas du job (0x5130).</translation>
    </message>
    <message>
        <source>The line begins with no instruction.</source>
        <translation>La ligne ne commence pas par une instruction.</translation>
    </message>
    <message>
        <source>An instruction was cut in two: it belongs to the line before (0x5110).</source>
        <translation>Une instruction a été coupée en deux&#xa0;: elle appartient à la ligne précédente (0x5110).</translation>
    </message>
    <message>
        <source>%1 is no instruction that this program knows.</source>
        <translation>%1 n’est pas une instruction connue de ce programme.</translation>
    </message>
    <message>
        <source>It may belong to an option; a controller without it refuses the job (0x5110).</source>
        <translation>Elle relève peut-être d’une option&#xa0;; un contrôleur sans celle-ci refuse le job (0x5110).</translation>
    </message>
    <message>
        <source>There are characters beyond ASCII outside of comments and texts.</source>
        <translation>Il y a des caractères non ASCII hors des commentaires et des textes.</translation>
    </message>
    <message>
        <source>Instructions are ASCII.</source>
        <translation>Les instructions sont en ASCII.</translation>
    </message>
    <message>
        <source>There is an empty line among the instructions.</source>
        <translation>Il y a une ligne vide parmi les instructions.</translation>
    </message>
    <message>
        <source>Controllers write none.</source>
        <translation>Les contrôleurs n’en écrivent pas.</translation>
    </message>
    <message>
        <source>The job has more than 10,000 lines.</source>
        <translation>Le job a plus de 10&#xa0;000 lignes.</translation>
    </message>
    <message>
        <source>Controllers number lines to 9999.</source>
        <translation>Les contrôleurs numérotent les lignes jusqu’à 9999.</translation>
    </message>
    <message>
        <source>A comment or message is longer than 32 bytes.</source>
        <translation>Un commentaire ou un message dépasse 32 octets.</translation>
    </message>
    <message>
        <source>Controllers cut it.</source>
        <translation>Les contrôleurs le coupent.</translation>
    </message>
    <message>
        <source>The label *%1 is longer than 8 bytes.</source>
        <translation>L’étiquette *%1 dépasse 8 octets.</translation>
    </message>
    <message>
        <source>Labels have 1 to 8 (0x4200).</source>
        <translation>Les étiquettes en ont de 1 à 8 (0x4200).</translation>
    </message>
    <message>
        <source>The label *%1 is there twice.</source>
        <translation>L’étiquette *%1 figure deux fois.</translation>
    </message>
    <message>
        <source>A jump would have two goals (0x4200).</source>
        <translation>Un saut aurait deux cibles (0x4200).</translation>
    </message>
    <message>
        <source>There is no label *%1.</source>
        <translation>Il n’y a pas d’étiquette *%1.</translation>
    </message>
    <message>
        <source>The jump gives an alarm when it is executed.</source>
        <translation>Le saut déclenche une alarme quand il est exécuté.</translation>
    </message>
    <message>
        <source>%1 is not closed.</source>
        <translation>%1 n’est pas fermé.</translation>
    </message>
    <message>
        <source>IFTHEN needs ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</source>
        <translation>IFTHEN exige ENDIF, WHILE ENDWHILE, FOR NEXT, SWITCH ENDSWITCH (0x5110).</translation>
    </message>
    <message>
        <source>%1 stands outside of what it belongs to.</source>
        <translation>%1 se trouve hors de ce dont il fait partie.</translation>
    </message>
    <message>
        <source>Structures are closed in the reverse order (0x5110).</source>
        <translation>Les structures se ferment dans l’ordre inverse (0x5110).</translation>
    </message>
    <message>
        <source>Structures are nested more than 10 deep.</source>
        <translation>Les structures sont imbriquées sur plus de 10 niveaux.</translation>
    </message>
    <message>
        <source>Controllers allow 10.</source>
        <translation>Les contrôleurs en autorisent 10.</translation>
    </message>
    <message>
        <source>%1 is out of range.</source>
        <translation>%1 est hors plage.</translation>
    </message>
    <message>
        <source>The controller may refuse it (0x5200).</source>
        <translation>Le contrôleur peut le refuser (0x5200).</translation>
    </message>
    <message>
        <source>There are more than 8 arguments.</source>
        <translation>Il y a plus de 8 arguments.</translation>
    </message>
    <message>
        <source>A job takes 8 (0x5110).</source>
        <translation>Un job en accepte 8 (0x5110).</translation>
    </message>
    <message>
        <source>%1 is beyond what ///LVARS provides.</source>
        <translation>%1 dépasse ce que prévoit ///LVARS.</translation>
    </message>
    <message>
        <source>The job has fewer local variables (0x5110).</source>
        <translation>Le job a moins de variables locales (0x5110).</translation>
    </message>
    <message>
        <source>Line %1 of the file, named by line %2: %3</source>
        <translation>Ligne %1 du fichier, nommée par la ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Line %1 (%2 in the file): %3</source>
        <translation>Ligne %1 (%2 dans le fichier)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Line %1 of the file: %2</source>
        <translation>Ligne %1 du fichier&#xa0;: %2</translation>
    </message>
    <message>
        <source>There is no ///NPOS.</source>
        <translation>Il n’y a pas de ///NPOS.</translation>
    </message>
</context>
<context>
    <name>inform::JobDiff</name>
    <message>
        <source>arm form: field %1 of RCONF %2 → %3</source>
        <translation>configuration du bras&#xa0;: champ %1 de RCONF %2 → %3</translation>
    </message>
    <message>
        <source>arm form: %1 → %2</source>
        <translation>configuration du bras&#xa0;: %1 → %2</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>%1 pulses in %2</source>
        <translation>%1 impulsions en %2</translation>
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
        <translation>%1 au total</translation>
    </message>
    <message>
        <source>moved %1</source>
        <translation>déplacé&#xa0;: %1</translation>
    </message>
    <message>
        <source>moved %1 (%2)</source>
        <translation>déplacé&#xa0;: %1 (%2)</translation>
    </message>
    <message>
        <source>type %1 → %2</source>
        <translation>type %1 → %2</translation>
    </message>
    <message>
        <source>tool %1 → %2</source>
        <translation>outil %1 → %2</translation>
    </message>
    <message>
        <source>user frame %1 → %2</source>
        <translation>repère utilisateur %1 → %2</translation>
    </message>
    <message>
        <source>marked as beyond the limit</source>
        <translation>marqué comme hors limite</translation>
    </message>
    <message>
        <source>no longer marked as beyond the limit</source>
        <translation>n’est plus marqué comme hors limite</translation>
    </message>
    <message>
        <source>values %1 → %2</source>
        <translation>valeurs %1 → %2</translation>
    </message>
    <message>
        <source>Made a relative job</source>
        <translation>Transformé en job relatif</translation>
    </message>
    <message>
        <source>No longer a relative job</source>
        <translation>N’est plus un job relatif</translation>
    </message>
    <message>
        <source>The job is locked against editing</source>
        <translation>Le job est verrouillé contre l’édition</translation>
    </message>
    <message>
        <source>The job is no longer locked against editing</source>
        <translation>Le job n’est plus verrouillé contre l’édition</translation>
    </message>
    <message>
        <source>Made a macro job</source>
        <translation>Transformé en job macro</translation>
    </message>
    <message>
        <source>No longer a macro job</source>
        <translation>N’est plus un job macro</translation>
    </message>
    <message>
        <source>Attribute %1 added</source>
        <translation>Attribut %1 ajouté</translation>
    </message>
    <message>
        <source>Attribute %1 removed</source>
        <translation>Attribut %1 retiré</translation>
    </message>
    <message>
        <source>Relative frame %1 added</source>
        <translation>Repère relatif %1 ajouté</translation>
    </message>
    <message>
        <source>Relative frame %1 removed</source>
        <translation>Repère relatif %1 retiré</translation>
    </message>
    <message>
        <source>Relative frame: %1 → %2</source>
        <translation>Repère relatif&#xa0;: %1 → %2</translation>
    </message>
    <message>
        <source>Job name: “%1” → “%2”</source>
        <translation>Nom du job&#xa0;: «&#xa0;%1&#xa0;» → «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Job folder: “%1” → “%2”</source>
        <translation>Dossier du job&#xa0;: «&#xa0;%1&#xa0;» → «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Comment of the job: “%1” → “%2”</source>
        <translation>Commentaire du job&#xa0;: «&#xa0;%1&#xa0;» → «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Control group GROUP%1: %2 → %3</source>
        <translation>Groupe d’axes GROUP%1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>Control group GROUP%1 added: %2</source>
        <translation>Groupe d’axes GROUP%1 ajouté&#xa0;: %2</translation>
    </message>
    <message>
        <source>Control group GROUP%1 removed: %2</source>
        <translation>Groupe d’axes GROUP%1 retiré&#xa0;: %2</translation>
    </message>
    <message>
        <source>Local variables %1: %2 → %3</source>
        <translation>Variables locales %1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1: %2 → %3</source>
        <translation>Alias de %1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>Alias of %1 added: %2</source>
        <translation>Alias de %1 ajouté&#xa0;: %2</translation>
    </message>
    <message>
        <source>Alias of %1 removed: %2</source>
        <translation>Alias de %1 retiré&#xa0;: %2</translation>
    </message>
    <message>
        <source>Argument %1: “%2” → “%3”</source>
        <translation>Argument %1&#xa0;: «&#xa0;%2&#xa0;» → «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>Line %1 %2</source>
        <translation>Ligne %1 %2</translation>
    </message>
    <message>
        <source>Line %1 %2 of %3</source>
        <translation>Ligne %1 %2 de %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 added</source>
        <translation>%1&#xa0;: %2 %3 ajouté</translation>
    </message>
    <message>
        <source>%1: %2 %3 removed</source>
        <translation>%1&#xa0;: %2 %3 retiré</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <comment>line and instruction, before, after</comment>
        <translation>%1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <comment>line and instruction, operand, before, after</comment>
        <translation>%1&#xa0;: %2 %3 → %4</translation>
    </message>
    <message>
        <source>Line %1 added: %2</source>
        <translation>Ligne %1 ajoutée&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1 added: %2 (new point: %3)</source>
        <translation>Ligne %1 ajoutée&#xa0;: %2 (nouveau point&#xa0;: %3)</translation>
    </message>
    <message>
        <source>Line %1 removed: %2</source>
        <translation>Ligne %1 retirée&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1 removed: %2 (with its point: %3)</source>
        <translation>Ligne %1 retirée&#xa0;: %2 (avec son point&#xa0;: %3)</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) moved from line %1 to line %2</source>
        <translation>
            <numerusform>%n ligne déplacée de la ligne %1 à la ligne %2</numerusform>
            <numerusform>%n lignes déplacées de la ligne %1 à la ligne %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 commented out: %2</source>
        <translation>Ligne %1 mise en commentaire&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer commented out: %2</source>
        <translation>Ligne %1 plus en commentaire&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1 locked against editing: %2</source>
        <translation>Ligne %1 verrouillée contre l’édition&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1 no longer locked against editing: %2</source>
        <translation>Ligne %1 plus verrouillée contre l’édition&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1, comment: “%2” → “%3”</source>
        <translation>Ligne %1, commentaire&#xa0;: «&#xa0;%2&#xa0;» → «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>Line %1, comment added: “%2”</source>
        <translation>Ligne %1, commentaire ajouté&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Line %1, comment removed: “%2”</source>
        <translation>Ligne %1, commentaire retiré&#xa0;: «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Line %1: %2 → %3</source>
        <translation>Ligne %1&#xa0;: %2 → %3</translation>
    </message>
    <message>
        <source>%1 added: %2</source>
        <comment>a position</comment>
        <translation>%1 ajoutée&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 removed: %2</source>
        <comment>a position</comment>
        <translation>%1 retirée&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a position</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>journal</name>
    <message>
        <source>%n record(s) of the journal are lost: neither the journal nor %1 could be written.</source>
        <translation>Entrées du journal perdues&#xa0;: %n. Ni le journal ni %1 n’ont pu être écrits.</translation>
    </message>
    <message>
        <source>%n record(s) could not be written into the journal. Orders and notes are kept in %1.</source>
        <translation>Entrées non écrites dans le journal&#xa0;: %n. Les ordres et les notes sont conservés dans %1.</translation>
    </message>
    <message>
        <source>What an earlier program left for the journal cannot be read: %1</source>
        <translation>Ce qu’un programme antérieur a laissé pour le journal ne peut pas être lu&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>journal::Database</name>
    <message>
        <source>The folder of the journal cannot be made.</source>
        <translation>Le dossier du journal ne peut pas être créé.</translation>
    </message>
    <message>
        <source>The journal was made by a newer version of Pendesk.</source>
        <translation>Le journal a été créé par une version plus récente de Pendesk.</translation>
    </message>
    <message>
        <source>The damaged journal cannot be given another name.</source>
        <translation>Le journal endommagé ne peut pas être renommé.</translation>
    </message>
</context>
<context>
    <name>journal::Store</name>
    <message>
        <source>The journal cannot be written: %1. Work goes on; records wait in memory.</source>
        <translation>Le journal ne peut pas être écrit&#xa0;: %1. Le travail continue&#xa0;; les entrées attendent en mémoire.</translation>
    </message>
    <message>
        <source>the disk does not answer</source>
        <translation>le disque ne répond pas</translation>
    </message>
</context>
<context>
    <name>models::ActiveAlarmModel</name>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Sub code</source>
        <translation>Sous-code</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Controller time</source>
        <translation>Heure du contrôleur</translation>
    </message>
    <message>
        <source>First seen</source>
        <translation>Première détection</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>The controller tells the newest four alarms only, and this is not one of them. It may be active.</source>
        <translation>Le contrôleur ne communique que les quatre alarmes les plus récentes, et celle-ci n’en fait pas partie. Elle peut être active.</translation>
    </message>
    <message>
        <source>First seen by this computer: %1</source>
        <translation>Première détection par cet ordinateur&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>models::AlarmHistoryModel</name>
    <message>
        <source>Controller time</source>
        <translation>Heure du contrôleur</translation>
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
        <translation>Sous-code</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Read here</source>
        <translation>Lu ici</translation>
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
        <translation>Nom</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Mean time between</source>
        <translation>Intervalle moyen</translation>
    </message>
    <message>
        <source>Last, controller time</source>
        <translation>Dernière, heure du contrôleur</translation>
    </message>
    <message>
        <source>%1 d %2 h</source>
        <translation>%1 j %2 h</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>under a minute</source>
        <translation>moins d’une minute</translation>
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
        <translation>ALARME</translation>
    </message>
    <message>
        <source>HELD</source>
        <translation>EN HOLD</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>HOLD&#xa0;: %1</translation>
    </message>
    <message>
        <source>RUNNING</source>
        <translation>MARCHE</translation>
    </message>
    <message>
        <source>TEACH</source>
        <translation>TEACH</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>ARRÊTÉ</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>NO LINK</source>
        <translation>SANS LIAISON</translation>
    </message>
    <message>
        <source>CHECKING</source>
        <translation>VÉRIFICATION</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>OFF</source>
        <translation>OFF</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1&#xa0;: %2. %3</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Endroit</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Aller-retour</translation>
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
        <translation>refusé</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
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
        <translation>%1 est en cours d’exécution.</translation>
    </message>
    <message>
        <source>%1, favourite</source>
        <translation>%1, favori</translation>
    </message>
</context>
<context>
    <name>models::OrderModel</name>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modification</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Personne</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordinateur</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
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
        <translation>en attente</translation>
    </message>
    <message>
        <source>under way</source>
        <translation>en cours</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>▲ %1</source>
        <translation>▲ %1</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>done, read back identical</source>
        <translation>terminé, relecture identique</translation>
    </message>
    <message numerus="yes">
        <source>done, the controller reformatted %n line(s)</source>
        <translation>
            <numerusform>terminé, le contrôleur a reformaté %n ligne</numerusform>
            <numerusform>terminé, le contrôleur a reformaté %n lignes</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ read back different</source>
        <translation>▲ relecture différente</translation>
    </message>
    <message>
        <source>▲ sent, but it could not be read back</source>
        <translation>▲ envoyé, mais la relecture n’a pas été possible</translation>
    </message>
    <message>
        <source>← to the computer</source>
        <translation>← vers l’ordinateur</translation>
    </message>
    <message>
        <source>→ to the controller</source>
        <translation>→ vers le contrôleur</translation>
    </message>
    <message>
        <source>✕ delete</source>
        <translation>✕ supprimer</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Débit</translation>
    </message>
    <message>
        <source>Remaining</source>
        <translation>Restant</translation>
    </message>
</context>
<context>
    <name>models::TrackModel</name>
    <message>
        <source>Not read at that time.</source>
        <translation>Non lu à ce moment.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Min in view</source>
        <translation>Min. affiché</translation>
    </message>
    <message>
        <source>Max in view</source>
        <translation>Max. affiché</translation>
    </message>
</context>
<context>
    <name>models::VariableModel</name>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Précédent</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>(empty)</source>
        <translation>(vide)</translation>
    </message>
    <message>
        <source>%1 (local)</source>
        <translation>%1 (local)</translation>
    </message>
    <message>
        <source>reads %1</source>
        <translation>lu %1</translation>
    </message>
    <message>
        <source>→ %1</source>
        <comment>new value</comment>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>wrote %1, reads %2</source>
        <translation>écrit %1, relu %2</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <comment>old and new value</comment>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>not sent yet</source>
        <translation>pas encore envoyé</translation>
    </message>
    <message>
        <source>not sent: %1</source>
        <translation>non envoyé&#xa0;: %1</translation>
    </message>
    <message>
        <source>being written…</source>
        <translation>écriture en cours…</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>refusé&#xa0;: %1</translation>
    </message>
    <message>
        <source>outcome unknown, look at the robot: %1</source>
        <translation>résultat inconnu, observer le robot&#xa0;: %1</translation>
    </message>
    <message>
        <source>accepted, but another value was read back</source>
        <translation>accepté, mais une autre valeur a été relue</translation>
    </message>
    <message>
        <source>The controller calls it “%1”.</source>
        <translation>Le contrôleur la nomme «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <comment>B007, value: 17</comment>
        <translation>%1, %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
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
        <translation>Dans les jobs</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Rising edges</source>
        <translation>Fronts montants</translation>
    </message>
    <message>
        <source>Falling edges</source>
        <translation>Fronts descendants</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
</context>
<context>
    <name>motion::JogStep</name>
    <message>
        <source>A step must be above 0 and at most %1 pulses.</source>
        <translation>Un pas doit être supérieur à 0 et d’au plus %1 impulsions.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1 mm.</source>
        <translation>Un pas doit être supérieur à 0 et d’au plus %1 mm.</translation>
    </message>
    <message>
        <source>A step must be above 0 and at most %1°.</source>
        <translation>Un pas doit être supérieur à 0 et d’au plus %1°.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>La position actuelle n’a pas été lue.</translation>
    </message>
    <message>
        <source>The group has no such axis.</source>
        <translation>Le groupe n’a pas cet axe.</translation>
    </message>
</context>
<context>
    <name>motion::Plan</name>
    <message>
        <source>The speed must be above 0 and at most %1 mm/s.</source>
        <translation>La vitesse doit être supérieure à 0 et d’au plus %1 mm/s.</translation>
    </message>
    <message>
        <source>The rotation speed must be above 0 and at most %1 °/s.</source>
        <translation>La vitesse de rotation doit être supérieure à 0 et d’au plus %1 °/s.</translation>
    </message>
    <message>
        <source>The joint speed must be above 0 and at most %1 %.</source>
        <translation>La vitesse articulaire doit être supérieure à 0 et d’au plus %1 %.</translation>
    </message>
    <message>
        <source>Where this frame stands cannot be read over HSES, so nobody here knows how far the move would go: use the base frame or an increment.</source>
        <translation>L’emplacement de ce repère est illisible par HSES&#xa0;; on ignore donc ici jusqu’où irait le mouvement&#xa0;: utiliser le repère base ou un incrément.</translation>
    </message>
    <message>
        <source>This robot stands on base axes, and HSES does not tell where they are in mm: enter where they shall be.</source>
        <translation>Ce robot est monté sur des axes de base, et HSES n’indique pas leur position en mm&#xa0;: saisir où ils doivent se trouver.</translation>
    </message>
    <message>
        <source>The position has no six axes.</source>
        <translation>La position n’a pas six axes.</translation>
    </message>
    <message>
        <source>The tool point stands outside the box of this controller.</source>
        <translation>Le point outil se trouve hors du volume limite de ce contrôleur.</translation>
    </message>
    <message>
        <source>The move would leave the box of this controller.</source>
        <translation>Le mouvement sortirait du volume limite de ce contrôleur.</translation>
    </message>
    <message>
        <source>User and tool frames are off until the profile says that they were checked on the robot.</source>
        <translation>Les repères utilisateur et outil sont désactivés tant que le profil n’indique pas qu’ils ont été vérifiés sur le robot.</translation>
    </message>
    <message>
        <source>The user frame must be from 1 to 63.</source>
        <translation>Le repère utilisateur doit être compris entre 1 et 63.</translation>
    </message>
    <message>
        <source>The tool must be from 0 to 63.</source>
        <translation>L’outil doit être compris entre 0 et 63.</translation>
    </message>
    <message>
        <source>A base or a station is moved in pulses.</source>
        <translation>Une base ou une station se déplace en impulsions.</translation>
    </message>
    <message>
        <source>The present position was not read.</source>
        <translation>La position actuelle n’a pas été lue.</translation>
    </message>
    <message>
        <source>A target in pulses can only be reached by a joint move: how far the tool point would go, and so how fast, is not known here.</source>
        <translation>Une cible en impulsions ne peut être atteinte que par un mouvement articulaire&#xa0;: la distance parcourue par le point outil, et donc sa vitesse, ne sont pas connues ici.</translation>
    </message>
    <message>
        <source>This controller has a box, and where pulses lead is not known here: use the base frame.</source>
        <translation>Ce contrôleur a un volume limite, et on ignore ici où mènent des impulsions&#xa0;: utiliser le repère base.</translation>
    </message>
</context>
<context>
    <name>names::Sentences</name>
    <message>
        <source>%1 has no signal #%2.</source>
        <translation>%1 n’a pas de signal #%2.</translation>
    </message>
    <message>
        <source>There is no #%1: the last digit of a signal is 0 to 7.</source>
        <translation>#%1 n’existe pas&#xa0;: le dernier chiffre d’un signal va de 0 à 7.</translation>
    </message>
    <message>
        <source>There is no %1#(%2): this controller has %1#(1) to %1#(%3).</source>
        <translation>%1#(%2) n’existe pas&#xa0;: ce contrôleur a %1#(1) à %1#(%3).</translation>
    </message>
    <message>
        <source>“%1” is not a signal. Write #00010, IN#(1) or OT#(1).</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un signal. Écrire #00010, IN#(1) ou OT#(1).</translation>
    </message>
</context>
<context>
    <name>pages::ActiveAlarmsCard</name>
    <message>
        <source>Active alarms</source>
        <translation>Alarmes actives</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Tout acquitter</translation>
    </message>
    <message>
        <source>Acknowledging is noted on this computer only. The robot does not hear of it.</source>
        <translation>L’acquittement n’est noté que sur cet ordinateur. Le robot n’en est pas informé.</translation>
    </message>
    <message>
        <source>Choose one or more alarms in the table first.</source>
        <translation>Choisir d’abord une ou plusieurs alarmes dans le tableau.</translation>
    </message>
    <message>
        <source>Whether there is an alarm is not known now.</source>
        <translation>On ignore actuellement s’il y a une alarme.</translation>
    </message>
    <message>
        <source>There is no alarm to clear.</source>
        <translation>Il n’y a pas d’alarme à réinitialiser.</translation>
    </message>
    <message>
        <source>Clears the alarms whose causes are gone.</source>
        <translation>Réinitialise les alarmes dont la cause a disparu.</translation>
    </message>
    <message>
        <source>Clears, if the cause is gone: %1.</source>
        <translation>Réinitialise, si la cause a disparu&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Whether there is an error is not known now.</source>
        <translation>On ignore actuellement s’il y a une erreur.</translation>
    </message>
    <message>
        <source>Clears the error message at the pendant, and no alarm.</source>
        <translation>Efface le message d’erreur sur le boîtier de programmation, mais aucune alarme.</translation>
    </message>
    <message>
        <source>There is no error to clear.</source>
        <translation>Il n’y a pas d’erreur à effacer.</translation>
    </message>
    <message>
        <source>Not connected: nothing is known of the active alarms.</source>
        <translation>Non connecté&#xa0;: les alarmes actives ne sont pas connues.</translation>
    </message>
    <message>
        <source>The alarms have not been read yet.</source>
        <translation>Les alarmes n’ont pas encore été lues.</translation>
    </message>
    <message>
        <source>The controller does not tell its alarms.</source>
        <translation>Le contrôleur ne communique pas ses alarmes.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active when last seen.</source>
        <translation>
            <numerusform>%n alarme active à la dernière lecture.</numerusform>
            <numerusform>%n alarmes actives à la dernière lecture.</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>Aucune alarme n’est active.</translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s) active, the newest first.</source>
        <translation>
            <numerusform>%n alarme active, la plus récente en premier.</numerusform>
            <numerusform>%n alarmes actives, la plus récente en premier.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reset accepted. Reading the alarms…</source>
        <translation>Réinitialisation acceptée. Lecture des alarmes…</translation>
    </message>
    <message>
        <source>Reset accepted. Whether an alarm is left is not known: the status cannot be read.</source>
        <translation>Réinitialisation acceptée. On ignore s’il reste une alarme&#xa0;: l’état est illisible.</translation>
    </message>
    <message>
        <source>Reset accepted. No alarm is active any more.</source>
        <translation>Réinitialisation acceptée. Plus aucune alarme n’est active.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first.</source>
        <translation>▲ Acceptée, encore active&#xa0;: éliminer d’abord la cause.</translation>
    </message>
    <message>
        <source>▲ Accepted, still active: remove the cause first. Left are: %1.</source>
        <translation>▲ Acceptée, encore active&#xa0;: éliminer d’abord la cause. Restent&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Cancel error accepted.</source>
        <translation>Effacement de l’erreur accepté.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmHistoryCard</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Past alarms</source>
        <translation>Alarmes passées</translation>
    </message>
    <message>
        <source>Most frequent</source>
        <translation>Plus fréquentes</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>All lists</source>
        <translation>Toutes les listes</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search code, text or time</source>
        <translation>Rechercher code, texte ou heure</translation>
    </message>
    <message>
        <source>Most frequent alarms</source>
        <translation>Alarmes les plus fréquentes</translation>
    </message>
    <message>
        <source>Counted in everything this journal has of the controller. The times between are by the controller&apos;s clock; steps of that clock are left out.</source>
        <translation>Comptées dans tout ce que ce journal contient du contrôleur. Les intervalles suivent l’horloge du contrôleur&#xa0;; les sauts de cette horloge sont exclus.</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>Note sur %1</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Arrêter la lecture</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>Lire maintenant</translation>
    </message>
    <message numerus="yes">
        <source>Reading the history from the controller: %n entry(s) read.</source>
        <translation>
            <numerusform>Lecture de l’historique du contrôleur&#xa0;: %n entrée lue.</numerusform>
            <numerusform>Lecture de l’historique du contrôleur&#xa0;: %n entrées lues.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>Le journal ne peut pas être lu&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>Reading was stopped. %n entry(s) in the journal.</source>
        <translation>
            <numerusform>La lecture a été arrêtée. %n entrée dans le journal.</numerusform>
            <numerusform>La lecture a été arrêtée. %n entrées dans le journal.</numerusform>
        </translation>
    </message>
    <message>
        <source>The history could not be read to its end: %1.</source>
        <translation>L’historique n’a pas pu être lu jusqu’à la fin&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n entry(s) of the journal; the export has all of them.</source>
        <translation>
            <numerusform>La plus récente (%n entrée) du journal&#xa0;; l’exportation les contient toutes.</numerusform>
            <numerusform>Les %n entrées les plus récentes du journal&#xa0;; l’exportation les contient toutes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) in the journal, kept for ever.</source>
        <translation>
            <numerusform>%n entrée dans le journal, conservée sans limite.</numerusform>
            <numerusform>%n entrées dans le journal, conservées sans limite.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export past alarms</source>
        <translation>Exporter les alarmes passées</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(s) exported.</source>
        <translation>
            <numerusform>%n entrée exportée.</numerusform>
            <numerusform>%n entrées exportées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>Non exporté&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>pages::AlarmNotes</name>
    <message>
        <source>Save note</source>
        <translation>Enregistrer la note</translation>
    </message>
    <message>
        <source>Export notes…</source>
        <translation>Exporter les notes…</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) exported.</source>
        <translation>
            <numerusform>%n note exportée.</numerusform>
            <numerusform>%n notes exportées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>Non exporté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Export notes</source>
        <translation>Exporter les notes</translation>
    </message>
    <message>
        <source>Codes with a note</source>
        <translation>Codes avec une note</translation>
    </message>
    <message>
        <source>Alarm code</source>
        <translation>Code d’alarme</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>What we did</source>
        <translation>Ce que nous avons fait</translation>
    </message>
    <message>
        <source>The notes cannot be read: %1.</source>
        <translation>Les notes ne peuvent pas être lues&#xa0;: %1.</translation>
    </message>
    <message>
        <source>No note yet.</source>
        <translation>Pas encore de note.</translation>
    </message>
    <message>
        <source>Last changed by %1, %2.</source>
        <translation>Dernière modification par %1, %2.</translation>
    </message>
</context>
<context>
    <name>pages::AxesCard</name>
    <message>
        <source>pulses</source>
        <translation>impulsions</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>following error, pulses</source>
        <translation>erreur de poursuite, impulsions</translation>
    </message>
    <message>
        <source>torque, raw</source>
        <translation>couple, brut</translation>
    </message>
    <message>
        <source>As the controller sends it: the unit is stated nowhere.</source>
        <translation>Tel que le contrôleur l’envoie&#xa0;: l’unité n’est indiquée nulle part.</translation>
    </message>
    <message>
        <source>encoder, °C</source>
        <translation>codeur, °C</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C</source>
        <translation>Convertisseur %1&#xa0;: %2 °C</translation>
    </message>
    <message>
        <source>Converter %1: %2 °C, last seen %3</source>
        <translation>Convertisseur %1&#xa0;: %2 °C, dernière lecture %3</translation>
    </message>
    <message>
        <source>Converter temperature: %1</source>
        <translation>Température du convertisseur&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>pages::BackupPage</name>
    <message>
        <source>Backups</source>
        <translation>Sauvegardes</translation>
    </message>
    <message>
        <source> newest</source>
        <translation> plus récentes</translation>
    </message>
    <message>
        <source>Keep any number</source>
        <translation>Conserver sans limite de nombre</translation>
    </message>
    <message>
        <source> days</source>
        <translation> jours</translation>
    </message>
    <message>
        <source>Keep any age</source>
        <translation>Conserver sans limite d’âge</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Sauvegarder maintenant</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Épingler</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message numerus="yes">
        <source>Good: every byte of %n file(s) is as it was written.</source>
        <translation>
            <numerusform>Correct&#xa0;: chaque octet de %n fichier est tel qu’il a été écrit.</numerusform>
            <numerusform>Correct&#xa0;: chaque octet de %n fichiers est tel qu’il a été écrit.</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ Not good: %1</source>
        <translation>▲ Incorrect&#xa0;: %1</translation>
    </message>
    <message>
        <source>After a backup keep</source>
        <translation>Après une sauvegarde, conserver</translation>
    </message>
    <message>
        <source>The last good backup and pinned ones are never deleted.</source>
        <translation>La dernière sauvegarde correcte et les sauvegardes épinglées ne sont jamais supprimées.</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparer avec</translation>
    </message>
    <message>
        <source>with the backup before</source>
        <translation>avec la sauvegarde précédente</translation>
    </message>
    <message>
        <source>with the newest backup</source>
        <translation>avec la sauvegarde la plus récente</translation>
    </message>
    <message>
        <source>with the controller now</source>
        <translation>avec le contrôleur maintenant</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>Restaurer…</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>Dans %1</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Désépingler</translation>
    </message>
    <message>
        <source>Choose a backup first.</source>
        <translation>Choisir d’abord une sauvegarde.</translation>
    </message>
    <message>
        <source>Files are being read.</source>
        <translation>Des fichiers sont en cours de lecture.</translation>
    </message>
    <message>
        <source>Reading file %1 of %2…</source>
        <translation>Lecture du fichier %1 sur %2…</translation>
    </message>
    <message>
        <source>Reading the lists…</source>
        <translation>Lecture des listes…</translation>
    </message>
    <message>
        <source>▲ There is no new backup: %1</source>
        <translation>▲ Il n’y a pas de nouvelle sauvegarde&#xa0;: %1</translation>
    </message>
    <message>
        <source>▲ %1 of %2 files were backed up.</source>
        <translation>▲ %1 fichiers sur %2 ont été sauvegardés.</translation>
    </message>
    <message numerus="yes">
        <source>All %n file(s) were backed up.</source>
        <translation>
            <numerusform>%n fichier a été sauvegardé.</numerusform>
            <numerusform>Tous les %n fichiers ont été sauvegardés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reading every byte…</source>
        <translation>Lecture de chaque octet…</translation>
    </message>
    <message>
        <source>There is no other backup to compare with.</source>
        <translation>Il n’y a pas d’autre sauvegarde à comparer.</translation>
    </message>
    <message>
        <source>The controller&apos;s files were read.</source>
        <translation>Les fichiers du contrôleur ont été lus.</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Folder of the backups</source>
        <translation>Dossier des sauvegardes</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Exported.</source>
        <translation>Exportée.</translation>
    </message>
    <message>
        <source>▲ Not exported: %1</source>
        <translation>▲ Non exportée : %1</translation>
    </message>
    <message>
        <source>Export the backup</source>
        <translation>Exporter la sauvegarde</translation>
    </message>
    <message>
        <source>Zip files (*.zip)</source>
        <translation>Fichiers zip (*.zip)</translation>
    </message>
    <message>
        <source>Exporting to %1…</source>
        <translation>Exportation vers %1…</translation>
    </message>
    <message>
        <source>the controller now</source>
        <translation>le contrôleur maintenant</translation>
    </message>
</context>
<context>
    <name>pages::CartesianCard</name>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min.</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max.</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>Point outil</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>Extended form</source>
        <translation>Configuration étendue</translation>
    </message>
    <message>
        <source>%1 · base frame, tool %2</source>
        <translation>%1 · repère base, outil %2</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · repère base</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 n’a pas de point outil&#xa0;: HSES ne l’indique que pour les robots.</translation>
    </message>
    <message>
        <source>%1, base frame, tool %2</source>
        <translation>%1, repère base, outil %2</translation>
    </message>
</context>
<context>
    <name>pages::ComparisonCard</name>
    <message>
        <source>≠ changed</source>
        <translation>≠ modifié</translation>
    </message>
    <message>
        <source>+ new</source>
        <translation>+ nouveau</translation>
    </message>
    <message>
        <source>− gone</source>
        <translation>− disparu</translation>
    </message>
    <message>
        <source>▲ not read, nobody knows</source>
        <translation>▲ non lu, inconnu</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modification</translation>
    </message>
    <message>
        <source>Files that differ</source>
        <translation>Fichiers différents</translation>
    </message>
    <message>
        <source>Choose a backup and compare it.</source>
        <translation>Choisir une sauvegarde et la comparer.</translation>
    </message>
    <message>
        <source>Not counted as a difference:</source>
        <translation>N’est pas compté comme différence&#xa0;:</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) differ</source>
        <translation>
            <numerusform>%n fichier diffère</numerusform>
            <numerusform>%n fichiers diffèrent</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a file above.</source>
        <translation>Choisir un fichier ci-dessus.</translation>
    </message>
    <message>
        <source>Nothing differs.</source>
        <translation>Aucune différence.</translation>
    </message>
    <message>
        <source>This file is not in the backup as it was written.</source>
        <translation>Ce fichier n’est pas dans la sauvegarde tel qu’il a été écrit.</translation>
    </message>
    <message>
        <source>not counted</source>
        <translation>non compté</translation>
    </message>
    <message>
        <source>Comparison: from %1 to %2</source>
        <translation>Comparaison&#xa0;: de %1 à %2</translation>
    </message>
    <message>
        <source>The files are being compared…</source>
        <translation>Comparaison des fichiers…</translation>
    </message>
    <message numerus="yes">
        <source>Not counted: %n counter(s), log(s) and the like</source>
        <translation>
            <numerusform>Non compté&#xa0;: %n compteur, journal ou similaire</numerusform>
            <numerusform>Non comptés&#xa0;: %n compteurs, journaux et similaires</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::CycleCard</name>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Actual</source>
        <translation>Réel</translation>
    </message>
    <message>
        <source>Requested here</source>
        <translation>Demandé ici</translation>
    </message>
    <message>
        <source>Nothing was requested from here.</source>
        <translation>Rien n’a été demandé d’ici.</translation>
    </message>
    <message>
        <source>Cycle mode to request</source>
        <translation>Mode de cycle à demander</translation>
    </message>
    <message>
        <source>Request</source>
        <translation>Demander</translation>
    </message>
</context>
<context>
    <name>pages::FilePane</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n fichier</numerusform>
            <numerusform>%n fichiers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::FilesPage</name>
    <message>
        <source>This computer</source>
        <translation>Cet ordinateur</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>← Fetch</source>
        <translation>← Récupérer</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Folder of the files</source>
        <translation>Dossier des fichiers</translation>
    </message>
    <message>
        <source>Type of the files</source>
        <translation>Type des fichiers</translation>
    </message>
    <message>
        <source>Send →</source>
        <translation>Envoyer →</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Supprimer…</translation>
    </message>
    <message>
        <source>There are no controller files in this folder.</source>
        <translation>Il n’y a pas de fichiers de contrôleur dans ce dossier.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>Lecture de la liste…</translation>
    </message>
    <message>
        <source>The controller lists no files of this type.</source>
        <translation>Le contrôleur ne liste aucun fichier de ce type.</translation>
    </message>
    <message>
        <source>Choose files on the left first.</source>
        <translation>Choisir d’abord des fichiers à gauche.</translation>
    </message>
    <message>
        <source>Choose files on the right first.</source>
        <translation>Choisir d’abord des fichiers à droite.</translation>
    </message>
</context>
<context>
    <name>pages::FleetPage</name>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Size of the tiles</source>
        <translation>Taille des tuiles</translation>
    </message>
    <message>
        <source>HOLD ALL</source>
        <translation>HOLD TOUS</translation>
    </message>
    <message>
        <source>HOLD all controllers (software)</source>
        <translation>HOLD de tous les contrôleurs (logiciel)</translation>
    </message>
    <message>
        <source>every station that is not off</source>
        <translation>chaque station qui n’est pas OFF</translation>
    </message>
    <message>
        <source>Connect all</source>
        <translation>Tout connecter</translation>
    </message>
    <message>
        <source>Back up all</source>
        <translation>Tout sauvegarder</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Tableau de bord</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tableau</translation>
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
        <translation>Contrôleurs</translation>
    </message>
    <message numerus="yes">
        <source>%n controller(s)</source>
        <translation>
            <numerusform>%n contrôleur</numerusform>
            <numerusform>%n contrôleurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n connected</source>
        <translation>
            <numerusform>%n connecté</numerusform>
            <numerusform>%n connectés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without link</source>
        <translation>
            <numerusform>%n sans liaison</numerusform>
            <numerusform>%n sans liaison</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n station(s) that are not off</source>
        <translation>
            <numerusform>%n station qui n’est pas OFF</numerusform>
            <numerusform>%n stations qui ne sont pas OFF</numerusform>
        </translation>
    </message>
    <message>
        <source>▲ HOLD was not confirmed by %1: look at the robot.</source>
        <translation>▲ HOLD n’a pas été confirmé par %1&#xa0;: regarder le robot.</translation>
    </message>
    <message>
        <source>HOLD is being asked of %1.</source>
        <translation>HOLD est demandé à %1.</translation>
    </message>
    <message numerus="yes">
        <source>HOLD was confirmed by %n controller(s).</source>
        <translation>
            <numerusform>HOLD a été confirmé par %n contrôleur.</numerusform>
            <numerusform>HOLD a été confirmé par %n contrôleurs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::GroupCard</name>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
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
        <translation>HOLD par</translation>
    </message>
</context>
<context>
    <name>pages::IoPage</name>
    <message>
        <source>User in</source>
        <translation>Entrées utilisateur</translation>
    </message>
    <message>
        <source>User out</source>
        <translation>Sorties utilisateur</translation>
    </message>
    <message>
        <source>External in</source>
        <translation>Entrées externes</translation>
    </message>
    <message>
        <source>Network in</source>
        <translation>Entrées réseau</translation>
    </message>
    <message>
        <source>External out</source>
        <translation>Sorties externes</translation>
    </message>
    <message>
        <source>Network out</source>
        <translation>Sorties réseau</translation>
    </message>
    <message>
        <source>System in</source>
        <translation>Entrées système</translation>
    </message>
    <message>
        <source>System out</source>
        <translation>Sorties système</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panneau</translation>
    </message>
    <message>
        <source>Relays</source>
        <translation>Relais</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Contrôle</translation>
    </message>
    <message>
        <source>Pseudo in</source>
        <translation>Pseudo-entrées</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Area of signals</source>
        <translation>Zone de signaux</translation>
    </message>
    <message>
        <source>Watched signals</source>
        <translation>Signaux suivis</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>Compter à partir de 0</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Over HSES only network inputs can be written: this lamp only shows.</source>
        <translation>Par HSES, seules les entrées réseau peuvent être écrites&#xa0;: ce voyant est en affichage seul.</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Écrire…</translation>
    </message>
    <message>
        <source>Name it here…</source>
        <translation>Nommer ici…</translation>
    </message>
    <message>
        <source>Take the local name away</source>
        <translation>Supprimer le nom local</translation>
    </message>
    <message>
        <source>Watch no longer</source>
        <translation>Ne plus suivre</translation>
    </message>
    <message>
        <source>Copy the address</source>
        <translation>Copier l’adresse</translation>
    </message>
    <message>
        <source>Edges are counted from what is read four times a second; shorter pulses are not seen.</source>
        <translation>Les fronts sont comptés d’après quatre lectures par seconde&#xa0;; les impulsions plus courtes ne sont pas vues.</translation>
    </message>
    <message>
        <source>Network inputs can be written: press Enter on a lamp.</source>
        <translation>Les entrées réseau peuvent être écrites&#xa0;: appuyer sur Entrée sur un voyant.</translation>
    </message>
    <message>
        <source>These lamps only show: over HSES only network inputs can be written.</source>
        <translation>Ces voyants sont en affichage seul&#xa0;: par HSES, seules les entrées réseau peuvent être écrites.</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) from %1 on are refused: %2.</source>
        <translation>
            <numerusform>%n groupe à partir de %1 est refusé&#xa0;: %2.</numerusform>
            <numerusform>%n groupes à partir de %1 sont refusés&#xa0;: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The controller&apos;s names are not known: %1.</source>
        <translation>Les noms du contrôleur ne sont pas connus&#xa0;: %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) of IONAME.DAT could not be read.</source>
        <translation>
            <numerusform>%n ligne de IONAME.DAT n’a pas pu être lue.</numerusform>
            <numerusform>%n lignes de IONAME.DAT n’ont pas pu être lues.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::JobCard</name>
    <message>
        <source>master task</source>
        <translation>tâche maître</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Job</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Correction de vitesse</translation>
    </message>
</context>
<context>
    <name>pages::JobListCard</name>
    <message>
        <source>Jobs on the controller</source>
        <translation>Jobs sur le contrôleur</translation>
    </message>
    <message>
        <source>★ Favourite</source>
        <translation>★ Favori</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Filter jobs by name</source>
        <translation>Filtrer les jobs par nom</translation>
    </message>
    <message>
        <source>The list could not be read: %1.</source>
        <translation>La liste n’a pas pu être lue&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Reading the list…</source>
        <translation>Lecture de la liste…</translation>
    </message>
    <message>
        <source>The list was not read yet.</source>
        <translation>La liste n’a pas encore été lue.</translation>
    </message>
    <message>
        <source>There is no job on the controller.</source>
        <translation>Il n’y a aucun job sur le contrôleur.</translation>
    </message>
    <message>
        <source>No job has “%1” in its name.</source>
        <translation>Aucun job ne contient «&#xa0;%1&#xa0;» dans son nom.</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>lecture en cours…</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s)</source>
        <translation>
            <numerusform>%n job</numerusform>
            <numerusform>%n jobs</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, read at %2</source>
        <translation>%1, lu à %2</translation>
    </message>
</context>
<context>
    <name>pages::JobTextCard</name>
    <message>
        <source>Job text</source>
        <translation>Texte du job</translation>
    </message>
    <message>
        <source>Choose a job in the list to read it.</source>
        <translation>Choisir un job dans la liste pour le lire.</translation>
    </message>
    <message>
        <source>Follow what is executed</source>
        <translation>Suivre l’exécution</translation>
    </message>
    <message>
        <source>Read again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Labels and calls</source>
        <translation>Étiquettes et appels</translation>
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
        <translation>lecture en cours…</translation>
    </message>
    <message>
        <source>read at %1</source>
        <translation>lu à %1</translation>
    </message>
    <message>
        <source>The job could not be read: %1.</source>
        <translation>Le job n’a pas pu être lu&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Read at %1. The controller was in TEACH or the link was lost since: this copy may be old.</source>
        <translation>Lu à %1. Depuis, le contrôleur a été en TEACH ou la liaison a été perdue&#xa0;: cette copie peut être périmée.</translation>
    </message>
    <message>
        <source>Reading the job…</source>
        <translation>Lecture du job…</translation>
    </message>
    <message>
        <source>The job was not read yet.</source>
        <translation>Le job n’a pas encore été lu.</translation>
    </message>
    <message>
        <source>This file holds no instructions that could be shown.</source>
        <translation>Ce fichier ne contient aucune instruction à afficher.</translation>
    </message>
</context>
<context>
    <name>pages::JobsPage</name>
    <message>
        <source>Orders</source>
        <translation>Ordres</translation>
    </message>
</context>
<context>
    <name>pages::JogCard</name>
    <message>
        <source>Jog</source>
        <translation>Déplacement manuel</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Keyboard too: hold Ctrl and Space on the button that has the focus</source>
        <translation>Également au clavier&#xa0;: maintenir Ctrl et Espace sur le bouton qui a le focus</translation>
    </message>
    <message>
        <source>Hold a button: one bounded step after another</source>
        <translation>Maintenir un bouton&#xa0;: un pas limité après l’autre</translation>
    </message>
    <message>
        <source>After a lost link</source>
        <translation>Après une perte de liaison</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>Dernier pas</translation>
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
        <translation>Axes (impulsions)</translation>
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
        <translation>au plus un pas&#xa0;: %1 impulsions</translation>
    </message>
    <message>
        <source>at most one step: %1 mm or %2°, in %3 s at most</source>
        <translation>au plus un pas&#xa0;: %1 mm ou %2°, en %3 s au plus</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>Désactivé&#xa0;: le profil a une limite de mouvement qui n’est pas un nombre supérieur à 0 (%1).</translation>
    </message>
    <message>
        <source>No answer to the step: whether it was taken is unknown. HOLD was sent. Look at the robot.</source>
        <translation>Aucune réponse au pas&#xa0;: on ignore s’il a été exécuté. HOLD a été envoyé. Observer le robot.</translation>
    </message>
    <message>
        <source>Step sent…</source>
        <translation>Le pas a été envoyé…</translation>
    </message>
    <message>
        <source>Moving…</source>
        <translation>En mouvement…</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at rest.</source>
        <translation>
            <numerusform>%n pas, immobile.</numerusform>
            <numerusform>%n pas, immobile.</numerusform>
        </translation>
    </message>
    <message>
        <source>None yet.</source>
        <translation>Aucun pour l’instant.</translation>
    </message>
</context>
<context>
    <name>pages::JournalPage</name>
    <message>
        <source>At any time</source>
        <translation>À tout moment</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Aujourd’hui</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>7 derniers jours</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>30 derniers jours</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Contrôleur</translation>
    </message>
    <message>
        <source>All controllers</source>
        <translation>Tous les contrôleurs</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Any outcome</source>
        <translation>Tout résultat</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search in all texts</source>
        <translation>Rechercher dans tous les textes</translation>
    </message>
    <message>
        <source>Reading the journal…</source>
        <translation>Lecture du journal…</translation>
    </message>
    <message>
        <source>The journal cannot be read: %1.</source>
        <translation>Le journal ne peut pas être lu&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Nothing was tried that fits this filter.</source>
        <translation>Aucune action ne correspond à ce filtre.</translation>
    </message>
    <message numerus="yes">
        <source>The newest %n record(s). Scroll down for older ones.</source>
        <translation>
            <numerusform>La plus récente (%n entrée). Faire défiler vers le bas pour les plus anciennes.</numerusform>
            <numerusform>Les %n entrées les plus récentes. Faire défiler vers le bas pour les plus anciennes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n record(s)</source>
        <translation>
            <numerusform>%n entrée</numerusform>
            <numerusform>%n entrées</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose a record to read all of it here.</source>
        <translation>Choisir une entrée pour la lire ici en entier.</translation>
    </message>
    <message>
        <source>%1: %2 at %3.</source>
        <translation>%1&#xa0;: %2 sur %3.</translation>
    </message>
    <message>
        <source>Outcome: %1.</source>
        <translation>Résultat&#xa0;: %1.</translation>
    </message>
    <message>
        <source>By %1 at %2, level %3.</source>
        <translation>Par %1 sur %2, niveau %3.</translation>
    </message>
    <message>
        <source>Export the journal</source>
        <translation>Exporter le journal</translation>
    </message>
    <message numerus="yes">
        <source>%n record(s) exported.</source>
        <translation>
            <numerusform>%n entrée exportée.</numerusform>
            <numerusform>%n entrées exportées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Not exported: %1.</source>
        <translation>Non exporté&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>pages::LinkCard</name>
    <message>
        <source>%1 repeated</source>
        <translation>%1 répétées</translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation>%1 sans réponse</translation>
    </message>
    <message>
        <source>%1 late</source>
        <translation>%1 en retard</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 en double</translation>
    </message>
    <message>
        <source>%1 mismatched</source>
        <translation>%1 non concordantes</translation>
    </message>
    <message>
        <source>%1 malformed</source>
        <translation>%1 mal formées</translation>
    </message>
    <message>
        <source>%1 from elsewhere</source>
        <translation>%1 d’une autre source</translation>
    </message>
    <message>
        <source>%1 busy</source>
        <translation>%1 occupé</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>last 60 s</source>
        <translation>dernières 60 s</translation>
    </message>
    <message>
        <source>round trip p50 / p95</source>
        <translation>aller-retour p50 / p95</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>requests</source>
        <translation>requêtes</translation>
    </message>
    <message>
        <source>last answer</source>
        <translation>dernière réponse</translation>
    </message>
    <message>
        <source>sent / answered</source>
        <translation>envoyées / répondues</translation>
    </message>
    <message>
        <source>unusual</source>
        <translation>inhabituel</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 /s of %2</source>
        <translation>%1 /s sur %2</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>il y a %1</translation>
    </message>
</context>
<context>
    <name>pages::MotionPage</name>
    <message>
        <source>Remote motion in automatic operation. The pendant’s enabling switch does not protect anyone here. Nobody may be inside the fence.</source>
        <translation>Mouvement à distance en fonctionnement automatique. L’interrupteur de validation du boîtier de programmation ne protège personne ici. Personne ne doit se trouver à l’intérieur de l’enceinte de protection.</translation>
    </message>
    <message>
        <source>Before each step</source>
        <translation>Avant chaque pas</translation>
    </message>
    <message>
        <source>Control group that moves</source>
        <translation>Groupe d’axes qui se déplace</translation>
    </message>
    <message>
        <source>Control group</source>
        <translation>Groupe d’axes</translation>
    </message>
</context>
<context>
    <name>pages::MoveCard</name>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Type of the move</source>
        <translation>Type de mouvement</translation>
    </message>
    <message>
        <source>Frame of the target</source>
        <translation>Repère de la cible</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>User frame</source>
        <translation>Repère utilisateur</translation>
    </message>
    <message>
        <source>Base axes in mm</source>
        <translation>Axes de base en mm</translation>
    </message>
    <message>
        <source>Rehearse…</source>
        <translation>Contrôle préalable…</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulaire</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Straight, increment</source>
        <translation>Linéaire, incrément</translation>
    </message>
    <message>
        <source>Base frame</source>
        <translation>Repère base</translation>
    </message>
    <message>
        <source>Robot frame</source>
        <translation>Repère robot</translation>
    </message>
    <message>
        <source>Tool frame</source>
        <translation>Repère outil</translation>
    </message>
    <message>
        <source>Pulses</source>
        <translation>Impulsions</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cible</translation>
    </message>
    <message>
        <source>change</source>
        <translation>variation</translation>
    </message>
    <message>
        <source>Speed in mm/s</source>
        <translation>Vitesse en mm/s</translation>
    </message>
    <message>
        <source>Rotation speed in °/s</source>
        <translation>Vitesse de rotation en °/s</translation>
    </message>
    <message>
        <source>Joint speed in %</source>
        <translation>Vitesse articulaire en %</translation>
    </message>
    <message>
        <source>mm/s, at most %1</source>
        <translation>mm/s, au plus %1</translation>
    </message>
    <message>
        <source>°/s, at most %1</source>
        <translation>°/s, au plus %1</translation>
    </message>
    <message>
        <source>% of joint speed, at most %1</source>
        <translation>% de la vitesse articulaire, au plus %1</translation>
    </message>
    <message>
        <source>Target of %1 in %2</source>
        <translation>Cible de %1 en %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>axis: reason</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>There are three base axes at most.</source>
        <translation>Il y a au plus trois axes de base.</translation>
    </message>
    <message>
        <source>Base axes: %1</source>
        <translation>Axes de base&#xa0;: %1</translation>
    </message>
    <message>
        <source>Off: the profile has a motion limit that is no number above 0 (%1).</source>
        <translation>Désactivé&#xa0;: le profil a une limite de mouvement qui n’est pas un nombre supérieur à 0 (%1).</translation>
    </message>
    <message>
        <source>Form: %1</source>
        <translation>Configuration&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>pages::Offers</name>
    <message>
        <source>Before sending</source>
        <translation>Avant l’envoi</translation>
    </message>
    <message numerus="yes">
        <source>Send %n file(s)</source>
        <translation>
            <numerusform>Envoyer %n fichier</numerusform>
            <numerusform>Envoyer %n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>on this computer</source>
        <translation>sur cet ordinateur</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>What would change in “%1”</source>
        <translation>Ce qui changerait dans «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>pages::OptionsCard</name>
    <message>
        <source>always: the button above, the Pause key or Ctrl+Shift+H.</source>
        <translation>toujours&#xa0;: le bouton ci-dessus, la touche Pause ou Ctrl+Maj+H.</translation>
    </message>
    <message>
        <source>sent repeatedly until confirmed or 2 s have passed. Have the pendant at hand.</source>
        <translation>envoyé de façon répétée jusqu’à confirmation ou jusqu’à 2 s écoulées. Garder le boîtier de programmation à portée de main.</translation>
    </message>
    <message>
        <source>there is no connection: use the pendant.</source>
        <translation>il n’y a pas de connexion&#xa0;: utiliser le boîtier de programmation.</translation>
    </message>
    <message>
        <source>What can I do now?</source>
        <translation>Que puis-je faire maintenant&#xa0;?</translation>
    </message>
    <message>
        <source>HOLD</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>possible</source>
        <translation>possible</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>impossible</translation>
    </message>
</context>
<context>
    <name>pages::PendantCard</name>
    <message>
        <source>Pendant</source>
        <translation>Boîtier de programmation</translation>
    </message>
    <message>
        <source>Message for the pendant</source>
        <translation>Message pour le boîtier de programmation</translation>
    </message>
    <message>
        <source>Show on the pendant</source>
        <translation>Afficher sur le boîtier de programmation</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n byte(s)</source>
        <translation>
            <numerusform>%1 sur %n octet</numerusform>
            <numerusform>%1 sur %n octets</numerusform>
        </translation>
    </message>
    <message>
        <source>Type a message first.</source>
        <translation>Saisir d’abord un message.</translation>
    </message>
    <message>
        <source>The controller&apos;s encoding cannot hold this: %1.</source>
        <translation>L’encodage du contrôleur ne peut pas représenter ceci&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The message is too long for the pendant.</source>
        <translation>Le message est trop long pour le boîtier de programmation.</translation>
    </message>
    <message>
        <source>HLOCK was switched on from here: the pendant is locked out, but for its emergency stop.</source>
        <translation>HLOCK a été activé d’ici&#xa0;: le boîtier de programmation est verrouillé, sauf son arrêt d’urgence.</translation>
    </message>
    <message>
        <source>HLOCK locks the pendant out. Whether it is on cannot be read over HSES; from here it was not switched on.</source>
        <translation>HLOCK verrouille le boîtier de programmation. Son état est illisible par HSES&#xa0;; il n’a pas été activé d’ici.</translation>
    </message>
</context>
<context>
    <name>pages::PointsBar</name>
    <message>
        <source>Take the present position</source>
        <translation>Reprendre la position actuelle</translation>
    </message>
    <message>
        <source>Take P</source>
        <translation>Reprendre P</translation>
    </message>
    <message>
        <source>Earlier places</source>
        <translation>Positions antérieures</translation>
    </message>
    <message>
        <source>Keep the present position as P</source>
        <translation>Conserver la position actuelle comme P</translation>
    </message>
    <message>
        <source>P variable</source>
        <translation>Variable P</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>Lecture de %1 en cours…</translation>
    </message>
    <message>
        <source>%1 could not be read: %2.</source>
        <translation>%1 n’a pas pu être lu&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1 is in another frame (%2): choose that frame and an absolute move to take it.</source>
        <translation>%1 est dans un autre repère (%2)&#xa0;: choisir ce repère et un mouvement absolu pour la reprendre.</translation>
    </message>
    <message>
        <source>The target is %1.</source>
        <translation>La cible est %1.</translation>
    </message>
    <message>
        <source>Only the present position of a robot can be kept, once it was read.</source>
        <translation>Seule la position actuelle d’un robot peut être conservée, une fois lue.</translation>
    </message>
    <message>
        <source>%1 was written and read back.</source>
        <translation>%1 a été écrit et relu.</translation>
    </message>
    <message>
        <source>%1 was not verified: %2.</source>
        <translation>%1 n’a pas été vérifié&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1 was written, but another value was read back.</source>
        <translation>%1 a été écrit, mais une autre valeur a été relue.</translation>
    </message>
    <message>
        <source>No move has begun in this frame yet</source>
        <translation>Aucun mouvement n’a encore commencé dans ce repère</translation>
    </message>
    <message>
        <source>%1 is not taught.</source>
        <translation>%1 n’est pas appris.</translation>
    </message>
    <message>
        <source>Other values are still being written.</source>
        <translation>D’autres valeurs sont encore en cours d’écriture.</translation>
    </message>
    <message>
        <source>%1 holds this position already.</source>
        <translation>%1 contient déjà cette position.</translation>
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
        <translation>R1 · repère base, outil %1  ·  impulsions</translation>
    </message>
    <message>
        <source>R1 · base frame  ·  pulses</source>
        <translation>R1 · repère base  ·  impulsions</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
</context>
<context>
    <name>pages::PositionPage</name>
    <message>
        <source>Control groups</source>
        <translation>Groupes d’axes</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>Réinitialiser min. et max.</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Copier comme texte</translation>
    </message>
    <message>
        <source>Not shown because refused: %1 of %2 control groups.</source>
        <translation>Non affichés car refusés&#xa0;: %1 groupes d’axes sur %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n control group(s)</source>
        <translation>
            <numerusform>%n groupe d’axes</numerusform>
            <numerusform>%n groupes d’axes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::QueueCard</name>
    <message>
        <source>Transfers</source>
        <translation>Transferts</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>Relancer les échecs</translation>
    </message>
    <message>
        <source>Clear finished</source>
        <translation>Effacer les terminés</translation>
    </message>
</context>
<context>
    <name>pages::RegistersPage</name>
    <message>
        <source>How registers are written</source>
        <translation>Notation des registres</translation>
    </message>
    <message>
        <source>Decimal</source>
        <translation>Décimal</translation>
    </message>
    <message>
        <source>Signed</source>
        <translation>Signé</translation>
    </message>
    <message>
        <source>Hexadecimal</source>
        <translation>Hexadécimal</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binaire</translation>
    </message>
    <message>
        <source>M000 to M559 can be written; the others belong to the ladder.</source>
        <translation>M000 à M559 peuvent être écrits&#xa0;; les autres appartiennent au programme ladder.</translation>
    </message>
</context>
<context>
    <name>pages::RemoteChanges</name>
    <message>
        <source>What changes in “%1” on %2</source>
        <translation>Ce qui change dans «&#xa0;%1&#xa0;» sur %2</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envoyer</translation>
    </message>
    <message>
        <source>Delete on %1</source>
        <translation>Supprimer sur %1</translation>
    </message>
    <message>
        <source>These files are deleted on %1:
%2
Before that each is copied to %3.</source>
        <translation>Ces fichiers sont supprimés sur %1&#xa0;:
%2
Auparavant, chacun est copié dans %3.</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n file(s)</source>
        <translation>
            <numerusform>Supprimer %n fichier</numerusform>
            <numerusform>Supprimer %n fichiers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>pages::SelectCard</name>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Select as</source>
        <translation>Sélectionner comme</translation>
    </message>
    <message>
        <source>to be executed</source>
        <translation>job à exécuter</translation>
    </message>
    <message>
        <source>master job</source>
        <translation>job maître</translation>
    </message>
    <message>
        <source>master job of sub task %1</source>
        <translation>job maître de la sous-tâche %1</translation>
    </message>
    <message>
        <source>From line</source>
        <translation>À partir de la ligne</translation>
    </message>
    <message>
        <source>line </source>
        <translation>ligne </translation>
    </message>
    <message>
        <source>Select %1</source>
        <translation>Sélectionner %1</translation>
    </message>
    <message>
        <source>Choose a job in the list first.</source>
        <translation>Choisir d’abord un job dans la liste.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>task %1</source>
        <translation>tâche %1</translation>
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
        <translation>Emplacement actuel</translation>
    </message>
    <message>
        <source>master task</source>
        <translation>tâche maître</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marche</translation>
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
        <translation>Alimentation servo</translation>
    </message>
    <message>
        <source>A job is running: servo off stops it at once.</source>
        <translation>Un job est en cours d’exécution&#xa0;: Servo OFF l’arrête immédiatement.</translation>
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
        <translation>Activer l’alimentation servo sur %1&#xa0;?

Dès lors, le robot peut se déplacer. Personne ne doit se trouver à l’intérieur de l’enceinte de protection.</translation>
    </message>
</context>
<context>
    <name>pages::StartCard</name>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Start…</source>
        <translation>Démarrer…</translation>
    </message>
</context>
<context>
    <name>pages::StartPanel</name>
    <message>
        <source>Start</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>Nothing is read and nothing is shown. Connecting only reads: nothing is written, started or moved by it.</source>
        <translation>Rien n’est lu et rien n’est affiché. La connexion ne fait que lire&#xa0;: elle n’écrit, ne démarre et ne déplace rien.</translation>
    </message>
    <message>
        <source>Connect to a controller…</source>
        <translation>Se connecter à un contrôleur…</translation>
    </message>
    <message>
        <source>A controller in your network</source>
        <translation>Un contrôleur du réseau</translation>
    </message>
    <message>
        <source>Enter its name or address. Pendesk checks step by step whether it answers, and says what is wrong where it does not.</source>
        <translation>Saisir son nom ou son adresse. Pendesk vérifie étape par étape s’il répond et, dans le cas contraire, indique ce qui ne va pas.</translation>
    </message>
    <message>
        <source>No robot at hand</source>
        <translation>Aucun robot disponible</translation>
    </message>
    <message>
        <source>The demo brings a simulated controller in this program. Everything can be tried with it, and no robot moves.</source>
        <translation>La démo fournit un contrôleur simulé dans ce programme. Tout peut être essayé avec lui, et aucun robot ne bouge.</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Ouvrir la démo</translation>
    </message>
    <message>
        <source>Recent controllers</source>
        <translation>Contrôleurs récents</translation>
    </message>
    <message>
        <source>Another controller…</source>
        <translation>Autre contrôleur…</translation>
    </message>
</context>
<context>
    <name>pages::StateCard</name>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Hold · pendant</source>
        <translation>HOLD · boîtier</translation>
    </message>
    <message>
        <source>Hold · external</source>
        <translation>HOLD · externe</translation>
    </message>
    <message>
        <source>Hold · command</source>
        <translation>HOLD · commande</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Limite de vitesse</translation>
    </message>
</context>
<context>
    <name>pages::SystemCard</name>
    <message>
        <source>System</source>
        <translation>Système</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the system information</source>
        <translation>Copier les informations système</translation>
    </message>
    <message>
        <source>The profile says %1, but this is the software of a %2: correct the profile.</source>
        <translation>Le profil indique %1, mais c’est le logiciel d’un %2&#xa0;: corriger le profil.</translation>
    </message>
</context>
<context>
    <name>pages::TasksCard</name>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Show the sub tasks</source>
        <translation>Afficher les sous-tâches</translation>
    </message>
    <message numerus="yes">
        <source>%n sub task(s)</source>
        <translation>
            <numerusform>%n sous-tâche</numerusform>
            <numerusform>%n sous-tâches</numerusform>
        </translation>
    </message>
    <message>
        <source>Sub task %1</source>
        <translation>Sous-tâche %1</translation>
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
        <translation>ARMÉ</translation>
    </message>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>NOT CONNECTED</source>
        <translation>NON CONNECTÉ</translation>
    </message>
    <message>
        <source>since %1</source>
        <translation>depuis %1</translation>
    </message>
    <message>
        <source>last seen: %1</source>
        <translation>dernière lecture&#xa0;: %1</translation>
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
        <translation>▲ n’est plus une sauvegarde</translation>
    </message>
    <message numerus="yes">
        <source>▲ %n file(s) missing</source>
        <translation>
            <numerusform>▲ %n fichier manquant</numerusform>
            <numerusform>▲ %n fichiers manquants</numerusform>
        </translation>
    </message>
    <message>
        <source>complete</source>
        <translation>complète</translation>
    </message>
    <message>
        <source>%1, pinned</source>
        <translation>%1, épinglée</translation>
    </message>
    <message>
        <source>Taken</source>
        <translation>Créée</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sauvegardes</translation>
    </message>
    <message>
        <source>Changed</source>
        <comment>number of files</comment>
        <translation>Modifiés</translation>
    </message>
</context>
<context>
    <name>pages::ToolPathCard</name>
    <message>
        <source>Tool path</source>
        <translation>Trajectoire de l’outil</translation>
    </message>
    <message>
        <source>Clear path</source>
        <translation>Effacer la trajectoire</translation>
    </message>
    <message>
        <source>%1 · base frame</source>
        <translation>%1 · repère base</translation>
    </message>
    <message>
        <source>%1 has no tool point: HSES tells it of robots only.</source>
        <translation>%1 n’a pas de point outil&#xa0;: HSES ne l’indique que pour les robots.</translation>
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
        <translation>Ajouter un signal…</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exporter en CSV…</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Freezes the view; recording goes on.</source>
        <translation>Fige l’affichage&#xa0;; l’enregistrement continue.</translation>
    </message>
    <message>
        <source>Back to live</source>
        <translation>Retour au direct</translation>
    </message>
    <message>
        <source>Time in view</source>
        <translation>Durée affichée</translation>
    </message>
    <message>
        <source>Trend</source>
        <translation>Tendance</translation>
    </message>
    <message>
        <source>Nothing is plotted yet. Drag a number here from any page, choose “Add to trend” in its menu, or add a signal.</source>
        <translation>Aucune courbe pour l’instant. Faire glisser ici un nombre de n’importe quelle page, choisir «&#xa0;Ajouter à la tendance&#xa0;» dans son menu, ou ajouter un signal.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Remove from trend</source>
        <translation>Retirer de la tendance</translation>
    </message>
    <message>
        <source>Incidents</source>
        <translation>Incidents</translation>
    </message>
    <message>
        <source>60 s before an alarm, 20 s after</source>
        <translation>60 s avant une alarme, 20 s après</translation>
    </message>
    <message>
        <source>Open incident</source>
        <translation>Ouvrir l’incident</translation>
    </message>
    <message>
        <source>No alarm has been recorded yet.</source>
        <translation>Aucune alarme n’a encore été enregistrée.</translation>
    </message>
    <message>
        <source>It could not be saved: %1</source>
        <translation>L’enregistrement n’a pas été possible&#xa0;: %1</translation>
    </message>
    <message>
        <source>Incident of %1: %2</source>
        <translation>Incident du %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Paused at %1; recording goes on</source>
        <translation>En pause à %1&#xa0;; l’enregistrement continue</translation>
    </message>
    <message>
        <source>Nothing is recorded: no communication</source>
        <translation>Rien n’est enregistré&#xa0;: pas de communication</translation>
    </message>
    <message>
        <source>Live; values of %1</source>
        <translation>En direct&#xa0;; valeurs de %1</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>%1 is refused by the controller.</source>
        <translation>%1 est refusé par le contrôleur.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>This incident cannot be read: %1</source>
        <translation>Cet incident ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>Export what is in view</source>
        <translation>Exporter ce qui est affiché</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>Fichiers CSV (*.csv)</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>Le fichier n’a pas pu être écrit&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariableSheet</name>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Undo last</source>
        <translation>Annuler le dernier</translation>
    </message>
    <message>
        <source>Registers</source>
        <translation>Registres</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Variables</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>%1 can only be read over HSES.</source>
        <translation>%1 ne peut être que lu par HSES.</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Écriture…</translation>
    </message>
    <message numerus="yes">
        <source>Apply %n…</source>
        <translation>
            <numerusform>Appliquer %n…</numerusform>
            <numerusform>Appliquer %n…</numerusform>
        </translation>
    </message>
    <message>
        <source>The values are being written.</source>
        <translation>Les valeurs sont en cours d’écriture.</translation>
    </message>
    <message>
        <source>Nothing is staged: press Enter in a value.</source>
        <translation>Rien n’est préparé&#xa0;: appuyer sur Entrée dans une valeur.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>Rien n’est préparé.</translation>
    </message>
    <message>
        <source>Stages the values that stood there before.</source>
        <translation>Prépare les valeurs qui s’y trouvaient auparavant.</translation>
    </message>
    <message>
        <source>Nothing was written that could be undone.</source>
        <translation>Rien n’a été écrit qui puisse être annulé.</translation>
    </message>
    <message>
        <source>Import values</source>
        <translation>Importer des valeurs</translation>
    </message>
    <message>
        <source>CSV files (*.csv)</source>
        <translation>Fichiers CSV (*.csv)</translation>
    </message>
    <message>
        <source>Export values</source>
        <translation>Exporter des valeurs</translation>
    </message>
    <message>
        <source>%1 stays as it is: %2</source>
        <comment>variable: reason</comment>
        <translation>%1 reste tel quel : %2</translation>
    </message>
</context>
<context>
    <name>pages::VariableTransfer</name>
    <message>
        <source>%1 was written.</source>
        <translation>%1 a été écrit.</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n variable(s)…</source>
        <translation>
            <numerusform>Lecture de %n variable…</numerusform>
            <numerusform>Lecture de %n variables…</numerusform>
        </translation>
    </message>
    <message>
        <source>The file cannot be read: %1</source>
        <translation>Le fichier ne peut pas être lu&#xa0;: %1</translation>
    </message>
    <message>
        <source>The file could not be written: %1</source>
        <translation>Le fichier n’a pas pu être écrit&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>pages::VariablesPage</name>
    <message>
        <source>Verify…</source>
        <translation>Vérifier…</translation>
    </message>
    <message>
        <source>Kind of variable</source>
        <translation>Type de variable</translation>
    </message>
    <message>
        <source>Compares two variables with the pendant. It only reads.</source>
        <translation>Compare deux variables avec le boîtier de programmation. Lecture seule.</translation>
    </message>
    <message>
        <source>New watch page…</source>
        <translation>Nouvelle page de suivi…</translation>
    </message>
    <message>
        <source>New watch page</source>
        <translation>Nouvelle page de suivi</translation>
    </message>
    <message>
        <source>Name of the page</source>
        <translation>Nom de la page</translation>
    </message>
    <message>
        <source>Watch: %1</source>
        <translation>Suivi&#xa0;: %1</translation>
    </message>
    <message>
        <source>Delete this watch page</source>
        <translation>Supprimer cette page de suivi</translation>
    </message>
    <message>
        <source>Show on the watch page “%1”</source>
        <translation>Afficher sur la page de suivi «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Take off this watch page</source>
        <translation>Retirer de cette page de suivi</translation>
    </message>
    <message>
        <source>There is no watch page yet.</source>
        <translation>Il n’y a pas encore de page de suivi.</translation>
    </message>
    <message>
        <source>Numbering not verified: nothing is written before it was compared with the pendant.</source>
        <translation>Numérotation non vérifiée&#xa0;: rien n’est écrit avant la comparaison avec le boîtier de programmation.</translation>
    </message>
    <message>
        <source>Simulation: number %1 on the network is B000.</source>
        <translation>Simulation&#xa0;: le numéro %1 sur le réseau est B000.</translation>
    </message>
    <message>
        <source>Numbering verified %1: number %2 on the network is B000.</source>
        <translation>Numérotation vérifiée %1&#xa0;: le numéro %2 sur le réseau est B000.</translation>
    </message>
</context>
<context>
    <name>pages::start::RecentTile</name>
    <message>
        <source>no connection noted yet</source>
        <translation>aucune connexion notée pour l’instant</translation>
    </message>
    <message>
        <source>connected today %1</source>
        <comment>the time</comment>
        <translation>connecté aujourd’hui à %1</translation>
    </message>
    <message>
        <source>connected yesterday %1</source>
        <comment>the time</comment>
        <translation>connecté hier à %1</translation>
    </message>
    <message>
        <source>connected %1 %2</source>
        <comment>the date, the time</comment>
        <translation>connecté le %1 à %2</translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation>Se connecter à %1</translation>
    </message>
    <message>
        <source>simulation</source>
        <translation>simulation</translation>
    </message>
</context>
<context>
    <name>pages::start::SetupCard</name>
    <message>
        <source>What must be set on the pendant</source>
        <translation>Ce qui doit être réglé sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>Menus differ by model and software</source>
        <translation>Les menus diffèrent selon le modèle et le logiciel</translation>
    </message>
    <message>
        <source>To be found</source>
        <translation>Pour être trouvé</translation>
    </message>
    <message>
        <source>The Ethernet server function (HSES) is on; it is an option of DX100, DX200 and FS100. The controller has an IPv4 address in the network of this computer, and no firewall between them drops UDP %1 and %2.</source>
        <translation>La fonction serveur Ethernet (HSES) est activée&#xa0;; c’est une option des DX100, DX200 et FS100. Le contrôleur a une adresse IPv4 dans le réseau de cet ordinateur, et aucun pare-feu entre les deux ne bloque UDP %1 et %2.</translation>
    </message>
    <message>
        <source>To take orders</source>
        <translation>Pour accepter des ordres</translation>
    </message>
    <message>
        <source>Only for starting, moving, resetting and files, not for reading: %1.</source>
        <translation>Seulement pour démarrer, déplacer, réinitialiser et pour les fichiers, pas pour lire&#xa0;: %1.</translation>
    </message>
    <message>
        <source>To select and replace</source>
        <translation>Pour sélectionner et remplacer</translation>
    </message>
    <message>
        <source>For selecting jobs from here: %1. For replacing files that exist there: %2.</source>
        <translation>Pour sélectionner des jobs d’ici&#xa0;: %1. Pour remplacer des fichiers qui y existent déjà&#xa0;: %2.</translation>
    </message>
</context>
<context>
    <name>pendesk</name>
    <message>
        <source>A teach and monitor desk for Yaskawa robot controllers.</source>
        <translation>Un poste d’apprentissage et de surveillance pour contrôleurs de robots Yaskawa.</translation>
    </message>
    <message>
        <source>Connect to a simulated controller inside the program.</source>
        <translation>Se connecter à un contrôleur simulé dans le programme.</translation>
    </message>
    <message>
        <source>light, dark, or auto for the desktop&apos;s choice.</source>
        <translation>light, dark, ou auto pour le choix du bureau.</translation>
    </message>
    <message>
        <source>Language of the window, as a code such as de; the desktop&apos;s unless told otherwise.</source>
        <translation>Langue de la fenêtre, sous forme de code tel que de&#xa0;; sauf indication contraire, celle du bureau.</translation>
    </message>
    <message>
        <source>Allow watching, HOLD and servo off alone, whatever the person at the desk tries.</source>
        <translation>N’autoriser que la surveillance, HOLD et Servo OFF, quoi que tente la personne au poste.</translation>
    </message>
    <message>
        <source>Write pictures of every page to this folder, print the status read, and end.</source>
        <translation>Écrire des images de toutes les pages dans ce dossier, afficher l’état lu et terminer.</translation>
    </message>
    <message>
        <source>Print when the window was painted and when the first status was live.</source>
        <translation>Afficher quand la fenêtre a été dessinée et quand le premier état était en direct.</translation>
    </message>
    <message>
        <source>--demo brings its own controller: leave out --host and --profile.</source>
        <translation>--demo fournit son propre contrôleur&#xa0;: omettre --host et --profile.</translation>
    </message>
    <message>
        <source>--theme must be light, dark or auto.</source>
        <translation>--theme doit être light, dark ou auto.</translation>
    </message>
    <message>
        <source>--language must be one of: %1.</source>
        <translation>--language doit être l’une de ces valeurs&#xa0;: %1.</translation>
    </message>
    <message>
        <source>“%1” is not an option.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une option.</translation>
    </message>
    <message>
        <source>--pictures needs a folder, and --demo, --host or --profile.</source>
        <translation>--pictures exige un dossier, et --demo, --host ou --profile.</translation>
    </message>
    <message>
        <source>Write one picture of all pages, light and dark, in English, German and Japanese, and end.</source>
        <translation>Écrire une image de toutes les pages, claires et sombres, en anglais, allemand et japonais, et terminer.</translation>
    </message>
    <message>
        <source>--contact-sheet needs a file, and --demo, --host or --profile.</source>
        <translation>--contact-sheet exige un fichier, et --demo, --host ou --profile.</translation>
    </message>
</context>
<context>
    <name>pendesk::Pictures</name>
    <message>
        <source>not everything was read</source>
        <translation>tout n’a pas été lu</translation>
    </message>
    <message>
        <source>pendesk: %1 cannot be written.</source>
        <translation>pendesk&#xa0;: %1 ne peut pas être écrit.</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Executing</source>
        <translation>En exécution</translation>
    </message>
    <message>
        <source>Pictures are in %1</source>
        <translation>Les images sont dans %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>le dossier %1 ne peut pas être créé</translation>
    </message>
    <message>
        <source>no live controller within 5 s: %1</source>
        <translation>aucun contrôleur en direct en 5 s&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 ne peut pas être écrit</translation>
    </message>
    <message>
        <source>pendesk: %1.</source>
        <translation>pendesk&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>pendeskctl</name>
    <message>
        <source>It stopped at %1. As it was it is in %2; “restore” that one with this name puts it back.</source>
        <translation>L’opération s’est arrêtée à %1. Son état précédent est dans %2&#xa0;; «&#xa0;restore&#xa0;» de cette sauvegarde avec ce nom le rétablit.</translation>
    </message>
    <message>
        <source>Delete all but the newest N backups afterwards, never the last good one.</source>
        <translation>Supprimer ensuite toutes les sauvegardes sauf les N plus récentes, jamais la dernière correcte.</translation>
    </message>
    <message>
        <source>Delete backups older than N days afterwards, never the last good one.</source>
        <translation>Supprimer ensuite les sauvegardes de plus de N jours, jamais la dernière correcte.</translation>
    </message>
    <message>
        <source>Reads all files of the controller into DIR/&lt;controller&gt;/&lt;UTC time&gt;, in BagIt form.</source>
        <translation>Lit tous les fichiers du contrôleur dans DIR/&lt;controller&gt;/&lt;UTC time&gt;, au format BagIt.</translation>
    </message>
    <message>
        <source>Reads a backup and tells whether it is what was written.</source>
        <translation>Lit une sauvegarde et indique si elle est telle qu’elle a été écrite.</translation>
    </message>
    <message>
        <source>Only print what would be done.</source>
        <translation>Afficher seulement ce qui serait fait.</translation>
    </message>
    <message>
        <source>The backup is not as it was written; “verify” tells what is wrong. Nothing was done with it.</source>
        <translation>La sauvegarde n’est pas telle qu’elle a été écrite&#xa0;; «&#xa0;verify&#xa0;» indique ce qui est incorrect. Rien n’a été fait avec elle.</translation>
    </message>
    <message>
        <source>“%1” is no file name.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nom de fichier.</translation>
    </message>
    <message>
        <source>Print for people instead of JSON.</source>
        <translation>Afficher pour lecture humaine au lieu de JSON.</translation>
    </message>
    <message>
        <source>The request that a reply answers.</source>
        <translation>La requête à laquelle une réponse se rapporte.</translation>
    </message>
    <message>
        <source>The port of the packets: 10040 or 10041.</source>
        <translation>Le port des paquets&#xa0;: 10040 ou 10041.</translation>
    </message>
    <message>
        <source>A packet; without any, one a line on stdin.</source>
        <translation>Un paquet&#xa0;; sans indication, un par ligne de stdin.</translation>
    </message>
    <message>
        <source>A job is running; files are not changed meanwhile.</source>
        <translation>Un job est en cours d’exécution&#xa0;; aucun fichier n’est modifié pendant ce temps.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address.</source>
        <translation>Le nom «&#xa0;%1&#xa0;» n’a pas d’adresse IPv4.</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>Le dossier «&#xa0;%1&#xa0;» ne peut pas être créé.</translation>
    </message>
    <message>
        <source>%1 exists and is left alone; --yes replaces it.</source>
        <translation>%1 existe et est laissé tel quel&#xa0;; --yes le remplace.</translation>
    </message>
    <message>
        <source>“%1” is no name that a controller takes.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nom accepté par un contrôleur.</translation>
    </message>
    <message>
        <source>%1 exists at the controller and is left alone; --replace replaces it.</source>
        <translation>%1 existe sur le contrôleur et est laissé tel quel&#xa0;; --replace le remplace.</translation>
    </message>
    <message>
        <source>Lists the jobs.</source>
        <translation>Liste les jobs.</translation>
    </message>
    <message>
        <source>The folder for what comes; for rm, for the copies.</source>
        <translation>Le dossier de réception&#xa0;; pour rm, celui des copies.</translation>
    </message>
    <message>
        <source>put: replace what the controller has.</source>
        <translation>put&#xa0;: remplacer ce que contient le contrôleur.</translation>
    </message>
    <message>
        <source>Say “ls”, “get NAME…”, “put FILE…” or “rm NAME…”.</source>
        <translation>Indiquer «&#xa0;ls&#xa0;», «&#xa0;get NAME…&#xa0;», «&#xa0;put FILE…&#xa0;» ou «&#xa0;rm NAME…&#xa0;».</translation>
    </message>
    <message>
        <source>read status, job, position and system information</source>
        <translation>lire l’état, le job, la position et les informations système</translation>
    </message>
    <message>
        <source>read model, system software and parameter version</source>
        <translation>lire le modèle, le logiciel système et la version des paramètres</translation>
    </message>
    <message>
        <source>read the active alarms, or a list of the history</source>
        <translation>lire les alarmes actives, ou une liste de l’historique</translation>
    </message>
    <message>
        <source>read where the robot stands</source>
        <translation>lire la position du robot</translation>
    </message>
    <message>
        <source>list the jobs</source>
        <translation>lister les jobs</translation>
    </message>
    <message>
        <source>read I/O, write a network input</source>
        <translation>lire les E/S, écrire une entrée réseau</translation>
    </message>
    <message>
        <source>read and write registers</source>
        <translation>lire et écrire des registres</translation>
    </message>
    <message>
        <source>read and write variables</source>
        <translation>lire et écrire des variables</translation>
    </message>
    <message>
        <source>list, read, send and delete files</source>
        <translation>lister, lire, envoyer et supprimer des fichiers</translation>
    </message>
    <message>
        <source>read all files of a controller into a new backup</source>
        <translation>lire tous les fichiers d’un contrôleur dans une nouvelle sauvegarde</translation>
    </message>
    <message>
        <source>tell whether a backup is what was written</source>
        <translation>indiquer si une sauvegarde est telle qu’elle a été écrite</translation>
    </message>
    <message>
        <source>compare two backups, or one with the controller</source>
        <translation>comparer deux sauvegardes, ou une avec le contrôleur</translation>
    </message>
    <message>
        <source>send back what differs from a backup</source>
        <translation>renvoyer ce qui diffère d’une sauvegarde</translation>
    </message>
    <message>
        <source>read values again and again</source>
        <translation>lire des valeurs de façon répétée</translation>
    </message>
    <message>
        <source>take packets given in hex apart</source>
        <translation>décomposer des paquets donnés en hexadécimal</translation>
    </message>
    <message>
        <source>Usage: pendeskctl VERB [options]</source>
        <translation>Utilisation&#xa0;: pendeskctl VERB [options]</translation>
    </message>
    <message>
        <source>pendeskctl VERB --help tells more.</source>
        <translation>pendeskctl VERB --help en dit plus.</translation>
    </message>
    <message>
        <source>there is no verb “%1”.</source>
        <translation>le verbe «&#xa0;%1&#xa0;» n’existe pas.</translation>
    </message>
    <message>
        <source>%1: the controller has no such row of I/O groups.</source>
        <translation>%1&#xa0;: le contrôleur n’a pas cette plage de groupes d’E/S.</translation>
    </message>
    <message>
        <source>Instance of the first variable on this controller, 0 or 1 (parameter RS022).</source>
        <translation>Instance de la première variable sur ce contrôleur, 0 ou 1 (paramètre RS022).</translation>
    </message>
    <message>
        <source>Print JSON.</source>
        <translation>Afficher en JSON.</translation>
    </message>
    <message>
        <source>Yes, write: what changes something does nothing without it.</source>
        <translation>Oui, écrire&#xa0;: sans cela, ce qui modifie quelque chose ne fait rien.</translation>
    </message>
    <message>
        <source>No progress and no remarks.</source>
        <translation>Ni progression ni remarques.</translation>
    </message>
    <message>
        <source>--numbering takes 0 or 1.</source>
        <translation>--numbering attend 0 ou 1.</translation>
    </message>
    <message>
        <source>Name the controller with --host or --profile.</source>
        <translation>Désigner le contrôleur avec --host ou --profile.</translation>
    </message>
    <message>
        <source>See pendeskctl %1 --help.</source>
        <translation>Voir pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>This changes something at the controller or on this computer. Add --yes to do it.</source>
        <translation>Ceci modifie quelque chose sur le contrôleur ou sur cet ordinateur. Ajouter --yes pour l’exécuter.</translation>
    </message>
    <message>
        <source>Say what to read.</source>
        <translation>Indiquer ce qu’il faut lire.</translation>
    </message>
    <message>
        <source>Positions are not written from the command line.</source>
        <translation>Les positions ne s’écrivent pas depuis la ligne de commande.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 ne peut pas être écrit.</translation>
    </message>
    <message>
        <source>Nobody has verified which instance a variable has on this controller. Compare one value with the pendant, then say --numbering 0 or --numbering 1.</source>
        <translation>Personne n’a vérifié quelle instance une variable a sur ce contrôleur. Comparer une valeur avec le boîtier de programmation, puis indiquer --numbering 0 ou --numbering 1.</translation>
    </message>
    <message>
        <source>Another value was read back: %1</source>
        <translation>Une autre valeur a été relue&#xa0;: %1</translation>
    </message>
    <message>
        <source>io set takes one signal, such as 27010, and 0 or 1.</source>
        <translation>io set attend un signal, tel que 27010, et 0 ou 1.</translation>
    </message>
    <message>
        <source>%1 cannot be written: HSES writes network inputs alone.</source>
        <translation>%1 ne peut pas être écrit&#xa0;: HSES n’écrit que les entrées réseau.</translation>
    </message>
    <message>
        <source>Say “get NAME…” or “set NAME VALUE”.</source>
        <translation>Indiquer «&#xa0;get NAME…&#xa0;» ou «&#xa0;set NAME VALUE&#xa0;».</translation>
    </message>
    <message>
        <source>Reads model, system software and parameter version.</source>
        <translation>Lit le modèle, le logiciel système et la version des paramètres.</translation>
    </message>
    <message>
        <source>In pulses instead of the base frame.</source>
        <translation>En impulsions au lieu du repère base.</translation>
    </message>
    <message>
        <source>A list of the history instead: major, minor, user, system or offline.</source>
        <translation>À la place, une liste de l’historique&#xa0;: major, minor, user, system ou offline.</translation>
    </message>
    <message>
        <source>Reads the active alarms, newest first.</source>
        <translation>Lit les alarmes actives, la plus récente en premier.</translation>
    </message>
    <message>
        <source>--history takes major, minor, user, system or offline.</source>
        <translation>--history attend major, minor, user, system ou offline.</translation>
    </message>
    <message>
        <source>Reads rows of I/O groups (2701..2710) or signals (27010, IN#(1)); writes one network input.</source>
        <translation>Lit des plages de groupes d’E/S (2701..2710) ou des signaux (27010, IN#(1))&#xa0;; écrit une entrée réseau.</translation>
    </message>
    <message>
        <source>Reads registers; writes one and reads it back.</source>
        <translation>Lit des registres&#xa0;; en écrit un et le relit.</translation>
    </message>
    <message>
        <source>Reads variables B I D R S P BP EX; writes one and reads it back.</source>
        <translation>Lit des variables B I D R S P BP EX&#xa0;; en écrit une et la relit.</translation>
    </message>
    <message>
        <source>Time between two readings: 1s, 200ms.</source>
        <translation>Temps entre deux lectures&#xa0;: 1s, 200ms.</translation>
    </message>
    <message>
        <source>End after so many readings.</source>
        <translation>Terminer après ce nombre de lectures.</translation>
    </message>
    <message>
        <source>Reads variables, registers (M005) and I/O again and again, one line of JSON with --json.</source>
        <translation>Lit des variables, registres (M005) et E/S de façon répétée, une ligne de JSON à la fois avec --json.</translation>
    </message>
    <message>
        <source>Reads status, executing job, position and system information once.</source>
        <translation>Lit une fois l’état, le job en exécution, la position et les informations système.</translation>
    </message>
    <message>
        <source>Lists, reads, sends and deletes files. Sent files are read back; before a file is deleted, a copy is written here. What exists is replaced by get with --yes, by put with --replace; put and rm need --yes.</source>
        <translation>Liste, lit, envoie et supprime des fichiers. Les fichiers envoyés sont relus ; avant la suppression d’un fichier, une copie est écrite ici. Ce qui existe est remplacé par get avec --yes, par put avec --replace ; put et rm exigent --yes.</translation>
    </message>
    <message>
        <source>The controller lists no file that “%1” matches.</source>
        <translation>Le contrôleur ne liste aucun fichier correspondant à « %1 ».</translation>
    </message>
    <message>
        <source>The controller is named with --host H, or with --profile NAME as Pendesk keeps it.</source>
        <translation>Le contrôleur est désigné par --host H, ou par --profile NAME tel que Pendesk le conserve.</translation>
    </message>
    <message>
        <source>What changes something does nothing without --yes.</source>
        <translation>Ce qui modifie quelque chose ne fait rien sans --yes.</translation>
    </message>
    <message>
        <source>Exit codes: 0 done, 1 differences, 2 wrong call, 3 no answer or outcome unknown, 4 refused,
5 local file error, 6 verification failed, 7 done in part.</source>
        <translation>Codes de sortie : 0 fait, 1 différences, 2 appel incorrect, 3 pas de réponse ou issue inconnue, 4 refusé,
5 erreur de fichier local, 6 vérification non réussie, 7 fait en partie.</translation>
    </message>
    <message>
        <source>Nobody has verified how this controller numbers its variables (parameter RS022), so these may be their neighbours. --numbering 0 or --numbering 1 settles it.</source>
        <translation>Personne n’a vérifié comment ce contrôleur numérote ses variables (paramètre RS022) ; celles-ci peuvent donc être leurs voisines. --numbering 0 ou --numbering 1 tranche.</translation>
    </message>
    <message>
        <source>Print this and end.</source>
        <translation>Afficher ceci et terminer.</translation>
    </message>
    <message>
        <source>Files restored: %1. The fresh backup is %2.</source>
        <translation>Fichiers restaurés : %1. La nouvelle sauvegarde est %2.</translation>
    </message>
    <message>
        <source>The software of the controller is another than that with which the numbering was verified. Verify it again, or say --numbering 0 or --numbering 1.</source>
        <translation>Le logiciel du contrôleur n’est pas celui avec lequel la numérotation a été vérifiée. Vérifiez-la de nouveau, ou indiquez --numbering 0 ou --numbering 1.</translation>
    </message>
    <message>
        <source>Also read ALL.PRM, which repeats the other parameter files and takes a real controller 45 s.</source>
        <translation>Lire aussi ALL.PRM, qui répète les autres fichiers de paramètres et demande 45 s à un contrôleur réel.</translation>
    </message>
    <message>
        <source>The encoding of texts, such as Shift_JIS.</source>
        <translation>L’encodage des textes, par exemple Shift_JIS.</translation>
    </message>
    <message>
        <source>Looks at jobs as before they are sent, and prints what is wrong or odd; exit code 1 if a controller would refuse one.</source>
        <translation>Examine des jobs comme avant leur envoi et affiche ce qui est incorrect ou étrange&#xa0;; code de sortie 1 si un contrôleur en refuserait un.</translation>
    </message>
    <message>
        <source>Say the files or a folder.</source>
        <translation>Indiquer les fichiers ou un dossier.</translation>
    </message>
    <message>
        <source>“%1” is no encoding.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un encodage.</translation>
    </message>
    <message>
        <source>Not counted: %1 counters, %2 logs, %3 other files with nothing but dates, hours or check lines.</source>
        <translation>Non comptés&#xa0;: %1 compteurs, %2 journaux, %3 autres fichiers n’ayant que dates, heures ou lignes de contrôle.</translation>
    </message>
    <message>
        <source>Count dates, counters, logs, blanks and line ends as differences too.</source>
        <translation>Compter aussi comme différences les dates, compteurs, journaux, espaces et fins de ligne.</translation>
    </message>
    <message>
        <source>Compares two backups or folders of controller files, or one with the controller, in words; exit code 1 if configuration or data differ.</source>
        <translation>Compare deux sauvegardes ou dossiers de fichiers du contrôleur, ou une avec le contrôleur, en mots&#xa0;; code de sortie 1 si la configuration ou les données diffèrent.</translation>
    </message>
    <message>
        <source>The encoding of texts: %1.</source>
        <translation>L’encodage des textes&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The controller model: %1.</source>
        <translation>Le modèle du contrôleur&#xa0;: %1.</translation>
    </message>
    <message>
        <source>look at jobs before they are sent</source>
        <translation>examiner des jobs avant leur envoi</translation>
    </message>
    <message>
        <source>tell what controller files say</source>
        <translation>indiquer ce que disent les fichiers du contrôleur</translation>
    </message>
    <message>
        <source>The encoding of the pendant&apos;s language instead of the stored one: %1.</source>
        <translation>L’encodage de la langue du boîtier de programmation au lieu de celui enregistré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>--encoding takes one of %1.</source>
        <translation>--encoding accepte l’un de %1.</translation>
    </message>
    <message>
        <source>--%1 takes a whole number that is not negative.</source>
        <translation>--%1 accepte un nombre entier non négatif.</translation>
    </message>
    <message>
        <source>%1 does not take “%2”. See pendeskctl %1 --help.</source>
        <translation>%1 n’accepte pas «&#xa0;%2&#xa0;». Voir pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>%1 takes %2. See pendeskctl %1 --help.</source>
        <translation>%1 attend %2. Voir pendeskctl %1 --help.</translation>
    </message>
    <message>
        <source>Reads where a control group stands: the first robot, or R2, B1, S1.</source>
        <translation>Lit la position d’un groupe d’axes&#xa0;: le premier robot, ou R2, B1, S1.</translation>
    </message>
    <message>
        <source>“%1” is no control group of a %2: say R1, B1 or S1.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un groupe d’axes d’un %2&#xa0;: indiquer R1, B1 ou S1.</translation>
    </message>
    <message>
        <source>The backup (left) is of another robot than the controller (right). Nothing was sent. Single jobs and names can be sent by their names.</source>
        <translation>La sauvegarde (à gauche) est d’un autre robot que le contrôleur (à droite). Rien n’a été envoyé. Des jobs et noms isolés peuvent être envoyés par leur nom.</translation>
    </message>
    <message>
        <source>Sends back what differs from a backup of the same robot: first a fresh backup beside it, then file by file, each read back. Tools, frames and areas only by name; parameters, calibration and ladder never; never while a job runs.</source>
        <translation>Renvoie ce qui diffère d’une sauvegarde du même robot&#xa0;: d’abord une nouvelle sauvegarde à côté, puis fichier par fichier, chacun relu. Outils, repères et zones seulement par leur nom&#xa0;; paramètres, calibrage et ladder jamais&#xa0;; jamais pendant qu’un job est en marche.</translation>
    </message>
    <message>
        <source>%1 bytes that are not a text.</source>
        <translation>%1 octets qui ne sont pas un texte.</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The encoding of the pendant.</source>
        <translation>L’encodage du boîtier de programmation.</translation>
    </message>
    <message>
        <source>Tells what controller files say: names, tools, frames, variables, parameters, ladder, logs. Addresses, users and passwords are masked.</source>
        <translation>Indique ce que disent les fichiers du contrôleur&#xa0;: noms, outils, repères, variables, paramètres, ladder, journaux. Adresses, utilisateurs et mots de passe sont masqués.</translation>
    </message>
    <message>
        <source>Say a backup, a folder or files.</source>
        <translation>Indiquer une sauvegarde, un dossier ou des fichiers.</translation>
    </message>
    <message>
        <source>There is no encoding “%1”.</source>
        <translation>Il n’y a pas d’encodage «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>--every takes a time such as 200ms or 1s.</source>
        <translation>--every accepte une durée telle que 200ms ou 1s.</translation>
    </message>
    <message>
        <source>Another signal of the group changed meanwhile; nothing was sent.</source>
        <translation>Un autre signal du groupe a changé entre-temps&#xa0;; rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>not used in these files</source>
        <translation>non utilisé dans ces fichiers</translation>
    </message>
    <message>
        <source>a job that is known when the line runs</source>
        <translation>un job connu à l’exécution de la ligne</translation>
    </message>
    <message>
        <source>no file has it</source>
        <translation>aucun fichier ne le contient</translation>
    </message>
    <message>
        <source>Tells where variables, signals, registers, tools, frames, macros, alarms and jobs are used: in jobs, in the ladder, in files of names.</source>
        <translation>Dit où les variables, signaux, registres, outils, repères, macros, alarmes et jobs sont utilisés : dans les jobs, le ladder et les fichiers de noms.</translation>
    </message>
    <message>
        <source>Say what to look for, such as B012, IN#(5) or a job.</source>
        <translation>Indiquez ce qui est cherché, par exemple B012, IN#(5) ou un job.</translation>
    </message>
    <message>
        <source>Tells which job calls, jumps to or starts which, line by line.</source>
        <translation>Dit ligne par ligne quel job appelle, atteint par saut ou lance quel autre.</translation>
    </message>
    <message>
        <source>Tells what is worth a look: jobs that nothing names, jobs that are missing, outputs with several writers, variables that are never written, tools that were not entered.</source>
        <translation>Dit ce qui mérite un coup d’œil : jobs jamais nommés, jobs absents, sorties écrites à plusieurs endroits, variables jamais écrites, outils non saisis.</translation>
    </message>
    <message>
        <source>tell where variables, signals and jobs are used</source>
        <translation>dire où variables, signaux et jobs sont utilisés</translation>
    </message>
    <message>
        <source>tell which job calls which</source>
        <translation>dire quel job appelle lequel</translation>
    </message>
    <message>
        <source>tell what in the files is worth a look</source>
        <translation>dire ce qui mérite un coup d’œil dans les fichiers</translation>
    </message>
</context>
<context>
    <name>pendeskctl::AlarmReader</name>
    <message>
        <source>There are no alarms.</source>
        <translation>Il n’y a pas d’alarmes.</translation>
    </message>
</context>
<context>
    <name>pendeskctl::Gap</name>
    <message>
        <source>Answers again after %1 s.</source>
        <translation>Répond à nouveau après %1 s.</translation>
    </message>
</context>
<context>
    <name>protocol</name>
    <message>
        <source>refused with status %1, which is not in the code list</source>
        <translation>refusé avec l’état %1, qui n’est pas dans la liste des codes</translation>
    </message>
    <message>
        <source>%1 refused, with a code that is not in the code list</source>
        <translation>%1 refusé, avec un code qui n’est pas dans la liste des codes</translation>
    </message>
    <message>
        <source>the controller did not answer; nothing was changed</source>
        <translation>le contrôleur n’a pas répondu&#xa0;; rien n’a été modifié</translation>
    </message>
    <message>
        <source>no answer: it may or may not have happened — look at the robot</source>
        <translation>pas de réponse&#xa0;: l’action a pu avoir lieu ou non — observer le robot</translation>
    </message>
    <message>
        <source>the answer does not fit the question</source>
        <translation>la réponse ne correspond pas à la question</translation>
    </message>
    <message>
        <source>nothing was sent</source>
        <translation>rien n’a été envoyé</translation>
    </message>
    <message>
        <source>this computer&apos;s network refused</source>
        <translation>le réseau de cet ordinateur a refusé</translation>
    </message>
    <message>
        <source>this cannot be sent to a controller</source>
        <translation>ceci ne peut pas être envoyé à un contrôleur</translation>
    </message>
    <message>
        <source>a file on this computer could not be read or written</source>
        <translation>un fichier sur cet ordinateur n’a pas pu être lu ou écrit</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>the command is faulty</source>
        <translation>la commande est erronée</translation>
    </message>
    <message>
        <source>the command has the wrong number of operands</source>
        <translation>la commande a un mauvais nombre d’opérandes</translation>
    </message>
    <message>
        <source>an operand is out of its range</source>
        <translation>un opérande est hors de sa plage</translation>
    </message>
    <message>
        <source>an operand has the wrong length</source>
        <translation>un opérande a une mauvaise longueur</translation>
    </message>
    <message>
        <source>the device holds too many files</source>
        <translation>le périphérique contient trop de fichiers</translation>
    </message>
    <message>
        <source>delete files that are not needed</source>
        <translation>supprimer les fichiers inutiles</translation>
    </message>
    <message>
        <source>the robot is running</source>
        <translation>le robot est en marche</translation>
    </message>
    <message>
        <source>wait until it has stopped, or hold it</source>
        <translation>attendre son arrêt, ou l’arrêter par HOLD</translation>
    </message>
    <message>
        <source>held by the pendant</source>
        <translation>HOLD par le boîtier de programmation</translation>
    </message>
    <message>
        <source>release HOLD on the pendant</source>
        <translation>annuler HOLD sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>held by the playback panel</source>
        <translation>HOLD par le panneau de lecture (playback)</translation>
    </message>
    <message>
        <source>release HOLD on the panel or pendant</source>
        <translation>annuler HOLD sur le panneau ou le boîtier de programmation</translation>
    </message>
    <message>
        <source>held by an external signal</source>
        <translation>HOLD par un signal externe</translation>
    </message>
    <message>
        <source>release the external hold signal</source>
        <translation>annuler le signal HOLD externe</translation>
    </message>
    <message>
        <source>held by a command</source>
        <translation>HOLD par une commande</translation>
    </message>
    <message>
        <source>switch HOLD off</source>
        <translation>désactiver HOLD</translation>
    </message>
    <message>
        <source>an alarm or error is present</source>
        <translation>une alarme ou une erreur est présente</translation>
    </message>
    <message>
        <source>remove its cause, then reset the alarm</source>
        <translation>éliminer sa cause, puis réinitialiser l’alarme</translation>
    </message>
    <message>
        <source>servo power is off</source>
        <translation>l’alimentation servo est coupée</translation>
    </message>
    <message>
        <source>switch servo on</source>
        <translation>activer le servo</translation>
    </message>
    <message>
        <source>the controller is in the wrong mode</source>
        <translation>le contrôleur est dans le mauvais mode</translation>
    </message>
    <message>
        <source>turn the pendant key to the mode needed, usually PLAY in REMOTE</source>
        <translation>tourner la clé du boîtier de programmation sur le mode requis, en général PLAY en REMOTE</translation>
    </message>
    <message>
        <source>the files are in use by another function</source>
        <translation>les fichiers sont utilisés par une autre fonction</translation>
    </message>
    <message>
        <source>try again in a moment</source>
        <translation>réessayer dans un instant</translation>
    </message>
    <message>
        <source>command remote is not enabled</source>
        <translation>CMD REMOTE n’est pas activé</translation>
    </message>
    <message>
        <source>turn the pendant key to REMOTE and enable command remote</source>
        <translation>tourner la clé du boîtier de programmation sur REMOTE et activer CMD REMOTE</translation>
    </message>
    <message>
        <source>this data may not be accessed</source>
        <translation>l’accès à ces données n’est pas autorisé</translation>
    </message>
    <message>
        <source>check the security mode and the data protection on the pendant</source>
        <translation>vérifier le mode de sécurité et la protection des données sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>this data may not be loaded</source>
        <translation>le chargement de ces données n’est pas autorisé</translation>
    </message>
    <message>
        <source>the data is being edited</source>
        <translation>les données sont en cours d’édition</translation>
    </message>
    <message>
        <source>leave the editor on the pendant</source>
        <translation>quitter l’éditeur sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>a coordinate conversion is in progress</source>
        <translation>une conversion de coordonnées est en cours</translation>
    </message>
    <message>
        <source>try again when it has ended</source>
        <translation>réessayer quand elle est terminée</translation>
    </message>
    <message>
        <source>servo power must be on first</source>
        <translation>l’alimentation servo doit d’abord être activée</translation>
    </message>
    <message>
        <source>the home position must be set or checked</source>
        <translation>la position d’origine doit être définie ou vérifiée</translation>
    </message>
    <message>
        <source>check the home position on the pendant</source>
        <translation>vérifier la position d’origine sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>the position must be checked</source>
        <translation>la position doit être vérifiée</translation>
    </message>
    <message>
        <source>confirm the position on the pendant</source>
        <translation>confirmer la position sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>the present position is not available</source>
        <translation>la position actuelle n’est pas disponible</translation>
    </message>
    <message>
        <source>the panel lock prohibits a change of mode or cycle</source>
        <translation>le verrouillage du panneau interdit un changement de mode ou de cycle</translation>
    </message>
    <message>
        <source>release the panel lock</source>
        <translation>déverrouiller le panneau</translation>
    </message>
    <message>
        <source>the panel lock prohibits a start</source>
        <translation>le verrouillage du panneau interdit un démarrage</translation>
    </message>
    <message>
        <source>the user frame is not taught</source>
        <translation>le repère utilisateur n’est pas appris</translation>
    </message>
    <message>
        <source>teach the user frame</source>
        <translation>apprendre le repère utilisateur</translation>
    </message>
    <message>
        <source>the user frame data is damaged</source>
        <translation>les données du repère utilisateur sont endommagées</translation>
    </message>
    <message>
        <source>teach the user frame again</source>
        <translation>apprendre à nouveau le repère utilisateur</translation>
    </message>
    <message>
        <source>the control group is wrong</source>
        <translation>le groupe d’axes est incorrect</translation>
    </message>
    <message>
        <source>choose a control group that this controller has</source>
        <translation>choisir un groupe d’axes que ce contrôleur possède</translation>
    </message>
    <message>
        <source>the base axis data is wrong</source>
        <translation>les données de l’axe de base sont incorrectes</translation>
    </message>
    <message>
        <source>a relative job may not be converted</source>
        <translation>la conversion d’un job relatif n’est pas autorisée</translation>
    </message>
    <message>
        <source>permit the conversion on the pendant</source>
        <translation>autoriser la conversion sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>a parameter prohibits calling the master job</source>
        <translation>un paramètre interdit l’appel du job maître</translation>
    </message>
    <message>
        <source>permit the master call on the pendant</source>
        <translation>autoriser l’appel du job maître sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>the master job may not be called while operating</source>
        <translation>l’appel du job maître n’est pas autorisé pendant le fonctionnement</translation>
    </message>
    <message>
        <source>wait until the operation has ended</source>
        <translation>attendre la fin du fonctionnement</translation>
    </message>
    <message>
        <source>the teach lock prohibits calling the master job</source>
        <translation>le verrouillage d’apprentissage interdit l’appel du job maître</translation>
    </message>
    <message>
        <source>release the teach lock</source>
        <translation>annuler le verrouillage d’apprentissage</translation>
    </message>
    <message>
        <source>robot calibration data is missing</source>
        <translation>les données de calibrage des robots sont absentes</translation>
    </message>
    <message>
        <source>calibrate the robots</source>
        <translation>calibrer les robots</translation>
    </message>
    <message>
        <source>servo power cannot be switched on</source>
        <translation>l’alimentation servo ne peut pas être activée</translation>
    </message>
    <message>
        <source>check the safety chain: emergency stop, safeguards, alarms</source>
        <translation>vérifier la chaîne de sécurité&#xa0;: arrêt d’urgence, protections, alarmes</translation>
    </message>
    <message>
        <source>the coordinate system cannot be set</source>
        <translation>le système de coordonnées ne peut pas être défini</translation>
    </message>
    <message>
        <source>no memory is left for jobs</source>
        <translation>plus de mémoire disponible pour les jobs</translation>
    </message>
    <message>
        <source>delete jobs that are not needed</source>
        <translation>supprimer les jobs inutiles</translation>
    </message>
    <message>
        <source>no memory is left for position data</source>
        <translation>plus de mémoire disponible pour les données de position</translation>
    </message>
    <message>
        <source>editing of this job is prohibited</source>
        <translation>l’édition de ce job est interdite</translation>
    </message>
    <message>
        <source>remove the edit lock of the job</source>
        <translation>annuler le verrouillage d’édition du job</translation>
    </message>
    <message>
        <source>a job of that name exists</source>
        <translation>un job de ce nom existe</translation>
    </message>
    <message>
        <source>delete or rename it, or permit overwriting</source>
        <translation>le supprimer ou le renommer, ou autoriser l’écrasement</translation>
    </message>
    <message>
        <source>the job was not found</source>
        <translation>le job n’a pas été trouvé</translation>
    </message>
    <message>
        <source>check the job name</source>
        <translation>vérifier le nom du job</translation>
    </message>
    <message>
        <source>no job is set for execution</source>
        <translation>aucun job n’est défini pour l’exécution</translation>
    </message>
    <message>
        <source>select a job first</source>
        <translation>sélectionner d’abord un job</translation>
    </message>
    <message>
        <source>position data is damaged</source>
        <translation>les données de position sont endommagées</translation>
    </message>
    <message>
        <source>load the job again from a backup</source>
        <translation>charger à nouveau le job depuis une sauvegarde</translation>
    </message>
    <message>
        <source>position data is missing</source>
        <translation>les données de position sont absentes</translation>
    </message>
    <message>
        <source>teach the missing position</source>
        <translation>apprendre la position manquante</translation>
    </message>
    <message>
        <source>the position variable has the wrong type</source>
        <translation>la variable de position est du mauvais type</translation>
    </message>
    <message>
        <source>write the type that the variable is declared with</source>
        <translation>écrire le type avec lequel la variable est déclarée</translation>
    </message>
    <message>
        <source>END was reached in a job that is not the master</source>
        <translation>END a été atteint dans un job qui n’est pas le job maître</translation>
    </message>
    <message>
        <source>instruction data is damaged</source>
        <translation>les données d’instruction sont endommagées</translation>
    </message>
    <message>
        <source>the job name has a character that is not allowed</source>
        <translation>le nom du job contient un caractère non autorisé</translation>
    </message>
    <message>
        <source>rename the job</source>
        <translation>renommer le job</translation>
    </message>
    <message>
        <source>a label has a character that is not allowed</source>
        <translation>une étiquette contient un caractère non autorisé</translation>
    </message>
    <message>
        <source>rename the label</source>
        <translation>renommer l’étiquette</translation>
    </message>
    <message>
        <source>this system does not have the instruction</source>
        <translation>ce système ne possède pas cette instruction</translation>
    </message>
    <message>
        <source>the job to convert has no steps</source>
        <translation>le job à convertir n’a pas de pas</translation>
    </message>
    <message>
        <source>the job is converted already</source>
        <translation>le job est déjà converti</translation>
    </message>
    <message>
        <source>the user frame must be taught</source>
        <translation>le repère utilisateur doit être appris</translation>
    </message>
    <message>
        <source>relative jobs or independent control are not permitted</source>
        <translation>les jobs relatifs ou la commande indépendante ne sont pas autorisés</translation>
    </message>
    <message>
        <source>an instruction has a syntax error</source>
        <translation>une instruction contient une erreur de syntaxe</translation>
    </message>
    <message>
        <source>correct the instruction</source>
        <translation>corriger l’instruction</translation>
    </message>
    <message>
        <source>the position data has an error</source>
        <translation>les données de position contiennent une erreur</translation>
    </message>
    <message>
        <source>correct the position section</source>
        <translation>corriger la section des positions</translation>
    </message>
    <message>
        <source>NOP or END is missing</source>
        <translation>NOP ou END est absent</translation>
    </message>
    <message>
        <source>begin the instructions with NOP and end them with END</source>
        <translation>commencer les instructions par NOP et les terminer par END</translation>
    </message>
    <message>
        <source>the format is wrong</source>
        <translation>le format est incorrect</translation>
    </message>
    <message>
        <source>the number of data is wrong</source>
        <translation>le nombre de données est incorrect</translation>
    </message>
    <message>
        <source>correct the counts in the NPOS line</source>
        <translation>corriger les nombres de la ligne NPOS</translation>
    </message>
    <message>
        <source>a value is out of range</source>
        <translation>une valeur est hors de la plage</translation>
    </message>
    <message>
        <source>correct the value</source>
        <translation>corriger la valeur</translation>
    </message>
    <message>
        <source>there is a syntax error outside the instructions</source>
        <translation>il y a une erreur de syntaxe hors des instructions</translation>
    </message>
    <message>
        <source>correct the header of the file</source>
        <translation>corriger l’en-tête du fichier</translation>
    </message>
    <message>
        <source>a pseudo instruction is wrong</source>
        <translation>une pseudo-instruction est incorrecte</translation>
    </message>
    <message>
        <source>correct the line that starts with slashes</source>
        <translation>corriger la ligne qui commence par des barres obliques</translation>
    </message>
    <message>
        <source>a record of a condition file has an error</source>
        <translation>un enregistrement d’un fichier de conditions contient une erreur</translation>
    </message>
    <message>
        <source>a record of a job has an error</source>
        <translation>un enregistrement d’un job contient une erreur</translation>
    </message>
    <message>
        <source>the data comes from a different system</source>
        <translation>les données proviennent d’un autre système</translation>
    </message>
    <message>
        <source>the welding type does not match</source>
        <translation>le type de soudage ne correspond pas</translation>
    </message>
    <message>
        <source>the robot or station is operating</source>
        <translation>le robot ou la station est en fonctionnement</translation>
    </message>
    <message>
        <source>back up when nothing moves</source>
        <translation>sauvegarder quand rien ne bouge</translation>
    </message>
    <message>
        <source>the device has too little memory</source>
        <translation>le périphérique a trop peu de mémoire</translation>
    </message>
    <message>
        <source>free memory on the device or use a larger one</source>
        <translation>libérer de la mémoire sur le périphérique ou en utiliser un plus grand</translation>
    </message>
    <message>
        <source>the device cannot be accessed</source>
        <translation>l’accès au périphérique est impossible</translation>
    </message>
    <message>
        <source>check that the device is inserted</source>
        <translation>vérifier que le périphérique est inséré</translation>
    </message>
    <message>
        <source>a backup was not expected now</source>
        <translation>une sauvegarde n’était pas attendue maintenant</translation>
    </message>
    <message>
        <source>the image is larger than the RAM area</source>
        <translation>l’image est plus grande que la zone RAM</translation>
    </message>
    <message>
        <source>enlarge the RAM area for backups</source>
        <translation>agrandir la zone RAM pour les sauvegardes</translation>
    </message>
    <message>
        <source>no memory was reserved at power-on</source>
        <translation>aucune mémoire n’a été réservée à la mise sous tension</translation>
    </message>
    <message>
        <source>switch the controller off and on</source>
        <translation>mettre le contrôleur hors tension puis sous tension</translation>
    </message>
    <message>
        <source>the backup file information cannot be accessed</source>
        <translation>l’accès aux informations du fichier de sauvegarde est impossible</translation>
    </message>
    <message>
        <source>the old backup could not be removed</source>
        <translation>l’ancienne sauvegarde n’a pas pu être supprimée</translation>
    </message>
    <message>
        <source>the backup could not be renamed</source>
        <translation>la sauvegarde n’a pas pu être renommée</translation>
    </message>
    <message>
        <source>the drive name is too long</source>
        <translation>le nom du lecteur est trop long</translation>
    </message>
    <message>
        <source>the device is the wrong one</source>
        <translation>ce n’est pas le bon périphérique</translation>
    </message>
    <message>
        <source>set the automatic backup to the RAM disk</source>
        <translation>régler la sauvegarde automatique sur le disque RAM</translation>
    </message>
    <message>
        <source>a system error occurred</source>
        <translation>une erreur système s’est produite</translation>
    </message>
    <message>
        <source>automatic backup is not available</source>
        <translation>la sauvegarde automatique n’est pas disponible</translation>
    </message>
    <message>
        <source>set up automatic backup on the pendant</source>
        <translation>configurer la sauvegarde automatique sur le boîtier de programmation</translation>
    </message>
    <message>
        <source>an automatic backup is running</source>
        <translation>une sauvegarde automatique est en cours</translation>
    </message>
    <message>
        <source>the controller does not know this command</source>
        <translation>le contrôleur ne connaît pas cette commande</translation>
    </message>
    <message>
        <source>the number does not exist on this controller</source>
        <translation>le numéro n’existe pas sur ce contrôleur</translation>
    </message>
    <message>
        <source>check the number and the variable numbering</source>
        <translation>vérifier le numéro et la numérotation des variables</translation>
    </message>
    <message>
        <source>the element does not exist on this controller</source>
        <translation>l’élément n’existe pas sur ce contrôleur</translation>
    </message>
    <message>
        <source>the reply would be too large for the hardware</source>
        <translation>la réponse serait trop grande pour le matériel</translation>
    </message>
    <message>
        <source>ask for less at once</source>
        <translation>demander moins à la fois</translation>
    </message>
    <message>
        <source>the reply would be too large</source>
        <translation>la réponse serait trop grande</translation>
    </message>
    <message>
        <source>the position variable is not defined</source>
        <translation>la variable de position n’est pas définie</translation>
    </message>
    <message>
        <source>teach or write it first</source>
        <translation>l’apprendre ou l’écrire d’abord</translation>
    </message>
    <message>
        <source>this data may not be used</source>
        <translation>l’utilisation de ces données n’est pas autorisée</translation>
    </message>
    <message>
        <source>the size of the request data is wrong</source>
        <translation>la taille des données de la requête est incorrecte</translation>
    </message>
    <message>
        <source>the data is not set</source>
        <translation>les données ne sont pas définies</translation>
    </message>
    <message>
        <source>set it first</source>
        <translation>les définir d’abord</translation>
    </message>
    <message>
        <source>the application is not registered</source>
        <translation>l’application n’est pas enregistrée</translation>
    </message>
    <message>
        <source>the type is not registered</source>
        <translation>le type n’est pas enregistré</translation>
    </message>
    <message>
        <source>the control group setting is wrong</source>
        <translation>le réglage du groupe d’axes est incorrect</translation>
    </message>
    <message>
        <source>name either robots or stations that this controller has</source>
        <translation>indiquer soit des robots, soit des stations que ce contrôleur possède</translation>
    </message>
    <message>
        <source>the speed setting is wrong</source>
        <translation>le réglage de la vitesse est incorrect</translation>
    </message>
    <message>
        <source>use percent for joint and mm/s or °/s for straight moves</source>
        <translation>utiliser un pourcentage pour les mouvements articulaires et mm/s ou °/s pour les mouvements linéaires</translation>
    </message>
    <message>
        <source>no speed is given</source>
        <translation>aucune vitesse n’est indiquée</translation>
    </message>
    <message>
        <source>give a speed above 0</source>
        <translation>indiquer une vitesse supérieure à 0</translation>
    </message>
    <message>
        <source>the coordinate system setting is wrong</source>
        <translation>le réglage du système de coordonnées est incorrect</translation>
    </message>
    <message>
        <source>the type or form setting is wrong</source>
        <translation>le réglage du type ou de la configuration est incorrect</translation>
    </message>
    <message>
        <source>the tool number is wrong</source>
        <translation>le numéro d’outil est incorrect</translation>
    </message>
    <message>
        <source>use 0 to 63</source>
        <translation>utiliser 0 à 63</translation>
    </message>
    <message>
        <source>the user frame number is wrong</source>
        <translation>le numéro de repère utilisateur est incorrect</translation>
    </message>
    <message>
        <source>use 1 to 63 with a user frame, else 0</source>
        <translation>utiliser 1 à 63 avec un repère utilisateur, sinon 0</translation>
    </message>
    <message>
        <source>internal error of the controller: data area</source>
        <translation>erreur interne du contrôleur&#xa0;: zone de données</translation>
    </message>
    <message>
        <source>internal error of the controller: reply area exceeded</source>
        <translation>erreur interne du contrôleur&#xa0;: zone de réponse dépassée</translation>
    </message>
    <message>
        <source>internal error of the controller: element size mismatch</source>
        <translation>erreur interne du contrôleur&#xa0;: taille d’élément non concordante</translation>
    </message>
    <message>
        <source>internal error of the controller: customised function</source>
        <translation>erreur interne du contrôleur&#xa0;: fonction personnalisée</translation>
    </message>
    <message>
        <source>another error</source>
        <translation>une autre erreur</translation>
    </message>
    <message>
        <source>busy with another command</source>
        <translation>occupé par une autre commande</translation>
    </message>
    <message>
        <source>another access is in progress</source>
        <translation>un autre accès est en cours</translation>
    </message>
    <message>
        <source>the backup parameter setting is wrong</source>
        <translation>le réglage des paramètres de sauvegarde est incorrect</translation>
    </message>
    <message>
        <source>the backup file was not created</source>
        <translation>le fichier de sauvegarde n’a pas été créé</translation>
    </message>
    <message>
        <source>check that the controller is in remote mode</source>
        <translation>vérifier que le contrôleur est en mode REMOTE</translation>
    </message>
    <message>
        <source>internal system error of the controller</source>
        <translation>erreur système interne du contrôleur</translation>
    </message>
    <message>
        <source>the transfer was dropped: nothing came in time</source>
        <translation>le transfert a été abandonné&#xa0;: rien n’est arrivé à temps</translation>
    </message>
    <message>
        <source>start the transfer again</source>
        <translation>relancer le transfert</translation>
    </message>
    <message>
        <source>the file cannot be overwritten</source>
        <translation>le fichier ne peut pas être écrasé</translation>
    </message>
    <message>
        <source>permit overwriting, or delete the file first</source>
        <translation>autoriser l’écrasement, ou supprimer d’abord le fichier</translation>
    </message>
    <message>
        <source>the file is missing or empty</source>
        <translation>le fichier est absent ou vide</translation>
    </message>
    <message>
        <source>check the file name</source>
        <translation>vérifier le nom du fichier</translation>
    </message>
    <message>
        <source>the path is wrong</source>
        <translation>le chemin est incorrect</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>vérifier le chemin</translation>
    </message>
    <message>
        <source>the file is not in the list</source>
        <translation>le fichier n’est pas dans la liste</translation>
    </message>
    <message>
        <source>the file may not be deleted</source>
        <translation>la suppression du fichier n’est pas autorisée</translation>
    </message>
    <message>
        <source>the directory may not be deleted</source>
        <translation>la suppression du répertoire n’est pas autorisée</translation>
    </message>
    <message>
        <source>files cannot be accessed while remote is off</source>
        <translation>l’accès aux fichiers est impossible tant que REMOTE est désactivé</translation>
    </message>
    <message>
        <source>the file was not found</source>
        <translation>le fichier n’a pas été trouvé</translation>
    </message>
    <message>
        <source>the path is too long</source>
        <translation>le chemin est trop long</translation>
    </message>
    <message>
        <source>use a shorter name</source>
        <translation>utiliser un nom plus court</translation>
    </message>
    <message>
        <source>packet without data</source>
        <translation>paquet sans données</translation>
    </message>
    <message>
        <source>packet too large</source>
        <translation>paquet trop grand</translation>
    </message>
    <message>
        <source>packet of size 0</source>
        <translation>paquet de taille 0</translation>
    </message>
    <message>
        <source>packet with a wrong block number</source>
        <translation>paquet avec un mauvais numéro de bloc</translation>
    </message>
    <message>
        <source>packet with a wrong ACK byte</source>
        <translation>paquet avec un mauvais octet ACK</translation>
    </message>
    <message>
        <source>packet of a wrong division</source>
        <translation>paquet d’une mauvaise division</translation>
    </message>
    <message>
        <source>check that robot and file port are not exchanged</source>
        <translation>vérifier que les ports du robot et des fichiers ne sont pas inversés</translation>
    </message>
    <message>
        <source>packet with a wrong access level</source>
        <translation>paquet avec un mauvais niveau d’accès</translation>
    </message>
    <message>
        <source>packet with a wrong header size</source>
        <translation>paquet avec une mauvaise taille d’en-tête</translation>
    </message>
    <message>
        <source>packet with a wrong identifier</source>
        <translation>paquet avec un mauvais identifiant</translation>
    </message>
    <message>
        <source>announced and received packet sizes differ</source>
        <translation>les tailles de paquet annoncée et reçue diffèrent</translation>
    </message>
    <message>
        <source>too many requests</source>
        <translation>trop de requêtes</translation>
    </message>
    <message>
        <source>ask less often, or try again in a moment</source>
        <translation>demander moins souvent, ou réessayer dans un instant</translation>
    </message>
    <message>
        <source>the mode was changed and the communication dropped</source>
        <translation>le mode a été changé et la communication interrompue</translation>
    </message>
    <message>
        <source>start again in the new mode</source>
        <translation>recommencer dans le nouveau mode</translation>
    </message>
</context>
<context>
    <name>robot::Controller</name>
    <message>
        <source>The name %1 is not known to this computer.</source>
        <translation>Le nom %1 n’est pas connu de cet ordinateur.</translation>
    </message>
</context>
<context>
    <name>robot::Diagnosis</name>
    <message>
        <source>Host name</source>
        <translation>Nom d’hôte</translation>
    </message>
    <message>
        <source>Way to the host</source>
        <translation>Chemin vers l’hôte</translation>
    </message>
    <message>
        <source>Robot port</source>
        <translation>Port du robot</translation>
    </message>
    <message>
        <source>System information</source>
        <translation>Informations système</translation>
    </message>
    <message>
        <source>File port</source>
        <translation>Port des fichiers</translation>
    </message>
    <message>
        <source>Not looked at, because the step before it failed.</source>
        <translation>Non examiné, car l’étape précédente a échoué.</translation>
    </message>
    <message>
        <source>The name “%1” has no IPv4 address on this computer.</source>
        <translation>Le nom «&#xa0;%1&#xa0;» n’a pas d’adresse IPv4 sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Check the spelling, or enter the controller&apos;s IPv4 address as the pendant shows it.</source>
        <translation>Vérifier l’orthographe, ou saisir l’adresse IPv4 du contrôleur telle que le boîtier de programmation l’affiche.</translation>
    </message>
    <message>
        <source>%1 is %2.</source>
        <translation>%1 est %2.</translation>
    </message>
    <message>
        <source>This computer cannot send to %1: %2.</source>
        <translation>Cet ordinateur ne peut pas envoyer à %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Check the cable and this computer&apos;s IPv4 address: it must be in the controller&apos;s network.</source>
        <translation>Vérifier le câble et l’adresse IPv4 de cet ordinateur&#xa0;: elle doit appartenir au réseau du contrôleur.</translation>
    </message>
    <message>
        <source>This computer can send to %1.</source>
        <translation>Cet ordinateur peut envoyer à %1.</translation>
    </message>
    <message>
        <source>Port %1 answers with a status.</source>
        <translation>Le port %1 répond par un état.</translation>
    </message>
    <message>
        <source>Port %1 answers but refuses to tell the status: %2</source>
        <translation>Le port %1 répond mais refuse de communiquer l’état&#xa0;: %2</translation>
    </message>
    <message>
        <source>Check on the pendant that the network function server is enabled for this computer.</source>
        <translation>Vérifier sur le boîtier de programmation que le serveur de fonctions réseau est activé pour cet ordinateur.</translation>
    </message>
    <message>
        <source>Answers come from another address than %1; they are ignored.</source>
        <translation>Des réponses viennent d’une autre adresse que %1&#xa0;; elles sont ignorées.</translation>
    </message>
    <message>
        <source>Look for a second network card or an address translation between this computer and the controller.</source>
        <translation>Rechercher une deuxième carte réseau ou une traduction d’adresse entre cet ordinateur et le contrôleur.</translation>
    </message>
    <message>
        <source>Something answers at port %1, but not with HSES.</source>
        <translation>Quelque chose répond au port %1, mais pas en HSES.</translation>
    </message>
    <message>
        <source>Check the address and the port: HSES is UDP %1 on a controller.</source>
        <translation>Vérifier l’adresse et le port&#xa0;: HSES utilise UDP %1 sur un contrôleur.</translation>
    </message>
    <message>
        <source>The host rejects port %1: %2.</source>
        <translation>L’hôte rejette le port %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The host is there, but no HSES server: enable the Ethernet server function on the controller.</source>
        <translation>L’hôte est présent, mais sans serveur HSES&#xa0;: activer la fonction serveur Ethernet sur le contrôleur.</translation>
    </message>
    <message>
        <source>Port %1 stays silent.</source>
        <translation>Le port %1 reste muet.</translation>
    </message>
    <message>
        <source>Check that the controller is on, that its Ethernet server function is enabled and that no firewall drops UDP %1.</source>
        <translation>Vérifier que le contrôleur est sous tension, que sa fonction serveur Ethernet est activée et qu’aucun pare-feu ne bloque UDP %1.</translation>
    </message>
    <message>
        <source>The controller runs %1.</source>
        <translation>Le contrôleur exécute %1.</translation>
    </message>
    <message>
        <source>The controller does not tell its system information: %1</source>
        <translation>Le contrôleur ne communique pas ses informations système&#xa0;: %1</translation>
    </message>
    <message>
        <source>Pendesk monitors only a controller that says what it is. Ask its maker for the HSES option.</source>
        <translation>Pendesk ne surveille qu’un contrôleur qui indique ce qu’il est. Demander l’option HSES à son fabricant.</translation>
    </message>
    <message>
        <source>Port %1 stays silent: files are unavailable, monitoring works.</source>
        <translation>Le port %1 reste muet&#xa0;: les fichiers sont indisponibles, la surveillance fonctionne.</translation>
    </message>
    <message>
        <source>Check that no firewall drops UDP %1.</source>
        <translation>Vérifier qu’aucun pare-feu ne bloque UDP %1.</translation>
    </message>
    <message>
        <source>Port %1 answers.</source>
        <translation>Le port %1 répond.</translation>
    </message>
</context>
<context>
    <name>session::FileSession</name>
    <message>
        <source>An empty file cannot be sent over HSES.</source>
        <translation>Un fichier vide ne peut pas être envoyé par HSES.</translation>
    </message>
</context>
<context>
    <name>settings</name>
    <message>
        <source>%1 must be a whole number from %2 to %3.</source>
        <translation>%1 doit être un nombre entier de %2 à %3.</translation>
    </message>
    <message>
        <source>The model “%1” is not known.</source>
        <translation>Le modèle «&#xa0;%1&#xa0;» n’est pas connu.</translation>
    </message>
    <message>
        <source>The text encoding “%1” is not known.</source>
        <translation>L’encodage du texte «&#xa0;%1&#xa0;» n’est pas connu.</translation>
    </message>
    <message>
        <source>The variable numbering must be 0 or 1.</source>
        <translation>La numérotation des variables doit être 0 ou 1.</translation>
    </message>
    <message>
        <source>Pulses per degree must be lists of numbers, one list for each control group.</source>
        <translation>Les impulsions par degré doivent être des listes de nombres, une liste par groupe d’axes.</translation>
    </message>
    <message>
        <source>The profile needs a name.</source>
        <translation>Le profil doit avoir un nom.</translation>
    </message>
    <message>
        <source>The profile needs the controller&apos;s host name or IPv4 address.</source>
        <translation>Le profil doit avoir le nom d’hôte ou l’adresse IPv4 du contrôleur.</translation>
    </message>
</context>
<context>
    <name>settings::CommandLine</name>
    <message>
        <source>--%1 must be a whole number from 1 to 65535.</source>
        <translation>--%1 doit être un nombre entier de 1 à 65535.</translation>
    </message>
    <message>
        <source>--timeout takes a time such as 300ms or 1s.</source>
        <translation>--timeout attend un temps tel que 300ms ou 1s.</translation>
    </message>
    <message>
        <source>There is no controller stored under the name “%1”.</source>
        <translation>Aucun contrôleur n’est enregistré sous le nom «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Connect to the controller with this name or IPv4 address.</source>
        <translation>Se connecter au contrôleur ayant ce nom ou cette adresse IPv4.</translation>
    </message>
    <message>
        <source>Its port for robot control, 10040 unless told otherwise.</source>
        <translation>Son port de commande du robot, 10040 sauf indication contraire.</translation>
    </message>
    <message>
        <source>Its port for file control, 10041 unless told otherwise.</source>
        <translation>Son port de gestion des fichiers, 10041 sauf indication contraire.</translation>
    </message>
    <message>
        <source>Connect to the controller that is stored under this name.</source>
        <translation>Se connecter au contrôleur enregistré sous ce nom.</translation>
    </message>
    <message>
        <source>How long to wait for one try of a read: 300ms, 1s.</source>
        <translation>Durée d’attente pour un essai de lecture&#xa0;: 300ms, 1s.</translation>
    </message>
    <message>
        <source>--%1 needs --host or --profile.</source>
        <translation>--%1 exige --host ou --profile.</translation>
    </message>
    <message>
        <source>--model must be dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>--model doit être dx100, dx200, fs100, yrc1000 ou yrc1000micro.</translation>
    </message>
    <message>
        <source>Its model: dx100, dx200, fs100, yrc1000 or yrc1000micro.</source>
        <translation>Son modèle&#xa0;: dx100, dx200, fs100, yrc1000 ou yrc1000micro.</translation>
    </message>
    <message>
        <source>What to log, as &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</source>
        <translation>Ce qui est consigné, par exemple &quot;pendesk.session=true;pendesk.journal.debug=false&quot;.</translation>
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
        <translation>Port des fichiers</translation>
    </message>
    <message>
        <source>Read time-out</source>
        <translation>Délai de lecture</translation>
    </message>
    <message>
        <source>File time-out</source>
        <translation>Délai des fichiers</translation>
    </message>
    <message>
        <source>Servo time-out</source>
        <translation>Délai du servo</translation>
    </message>
    <message>
        <source>Repeats of a read</source>
        <translation>Répétitions d’une lecture</translation>
    </message>
    <message>
        <source>Requests outstanding at once</source>
        <translation>Requêtes simultanées en attente</translation>
    </message>
    <message>
        <source>Requests a second</source>
        <translation>Requêtes par seconde</translation>
    </message>
</context>
<context>
    <name>settings::SettingsFile</name>
    <message>
        <source>The last good ones, of %1, are used.</source>
        <translation>Les dernières correctes, du %1, sont utilisées.</translation>
    </message>
    <message>
        <source>There is no good copy of them.</source>
        <translation>Il n’en existe pas de copie correcte.</translation>
    </message>
    <message>
        <source>The settings in %1 are gone.</source>
        <translation>Les réglages dans %1 ont disparu.</translation>
    </message>
    <message>
        <source>The settings cannot be read: %1.</source>
        <translation>Les réglages ne peuvent pas être lus&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The settings are damaged; they are kept as %1.</source>
        <translation>Les réglages sont endommagés&#xa0;; ils sont conservés sous %1.</translation>
    </message>
    <message>
        <source>another program holds %1</source>
        <translation>un autre programme occupe %1</translation>
    </message>
    <message>
        <source>Settings could not be saved in time and are lost: %1</source>
        <translation>Des réglages n’ont pas pu être enregistrés à temps et sont perdus&#xa0;: %1</translation>
    </message>
    <message>
        <source>Settings cannot be saved: %1. Work goes on; it is tried again.</source>
        <translation>Réglages impossibles à enregistrer&#xa0;: %1. Le travail continue&#xa0;; nouvel essai à suivre.</translation>
    </message>
    <message numerus="yes">
        <source>%n entry(ies) of the earlier settings cannot be read; they stay in %1.</source>
        <translation>
            <numerusform>%n entrée des réglages antérieurs ne peut pas être lue&#xa0;; elle reste dans %1.</numerusform>
            <numerusform>%n entrées des réglages antérieurs ne peuvent pas être lues&#xa0;; elles restent dans %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>station::Fleet</name>
    <message>
        <source>%1: %2</source>
        <comment>controller: sentence</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>station::Station</name>
    <message numerus="yes">
        <source>%n staged value(s) were not applied.</source>
        <translation>
            <numerusform>%n valeur préparée n’a pas été appliquée.</numerusform>
            <numerusform>%n valeurs préparées n’ont pas été appliquées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Files are still being transferred.</source>
        <translation>Des fichiers sont encore en cours de transfert.</translation>
    </message>
    <message>
        <source>Files are still being read or sent for a backup, a comparison or a restore.</source>
        <translation>Des fichiers sont encore lus ou envoyés pour une sauvegarde, une comparaison ou une restauration.</translation>
    </message>
</context>
<context>
    <name>trend</name>
    <message>
        <source>Alarm %1 [%2] %3</source>
        <translation>Alarme %1 [%2] %3</translation>
    </message>
    <message>
        <source>Job %1</source>
        <translation>Job %1</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Step mode</source>
        <translation>Mode pas à pas</translation>
    </message>
    <message>
        <source>One cycle</source>
        <translation>Un cycle</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continu</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marche</translation>
    </message>
    <message>
        <source>Speed limit</source>
        <translation>Limite de vitesse</translation>
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
        <translation>HOLD par le boîtier de programmation</translation>
    </message>
    <message>
        <source>Held externally</source>
        <translation>HOLD externe</translation>
    </message>
    <message>
        <source>Held by command</source>
        <translation>HOLD par commande</translation>
    </message>
    <message>
        <source>Alarm active</source>
        <translation>Alarme active</translation>
    </message>
    <message>
        <source>Error active</source>
        <translation>Erreur active</translation>
    </message>
    <message>
        <source>Servo on</source>
        <translation>Servo ON</translation>
    </message>
    <message>
        <source>Job line</source>
        <translation>Ligne du job</translation>
    </message>
    <message>
        <source>Job step</source>
        <translation>Pas du job</translation>
    </message>
    <message>
        <source>Speed override</source>
        <translation>Correction de vitesse</translation>
    </message>
    <message>
        <source>%1, sub task %2</source>
        <translation>%1, sous-tâche %2</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 following error</source>
        <translation>%1 %2 erreur de poursuite</translation>
    </message>
    <message>
        <source>%1 %2 torque</source>
        <translation>%1 %2 couple</translation>
    </message>
    <message>
        <source>%1 %2 encoder temperature</source>
        <translation>%1 %2 température du codeur</translation>
    </message>
    <message>
        <source>pulses</source>
        <translation>impulsions</translation>
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
        <translation>Température du convertisseur, carte %1</translation>
    </message>
    <message>
        <source>Running time %1</source>
        <translation>Temps de marche %1</translation>
    </message>
    <message>
        <source>Alarm code %1</source>
        <translation>Code d’alarme %1</translation>
    </message>
</context>
<context>
    <name>trend::Recorder</name>
    <message>
        <source>An incident is lost: %1 could not be written in time.</source>
        <translation>Un incident est perdu&#xa0;: %1 n’a pas pu être écrit à temps.</translation>
    </message>
</context>
<context>
    <name>ui::AccessSwitch</name>
    <message>
        <source>Passcode and idle time…</source>
        <translation>Code d’accès et délai d’inactivité…</translation>
    </message>
    <message>
        <source>Access level: %1</source>
        <translation>Niveau d’accès&#xa0;: %1</translation>
    </message>
    <message>
        <source>This program was started with --monitor-only: it watches and holds.</source>
        <translation>Ce programme a été démarré avec --monitor-only&#xa0;: il surveille et peut envoyer HOLD.</translation>
    </message>
    <message numerus="yes">
        <source>What may be done from here. It falls back to Monitor after %n minute(s) without key or mouse.</source>
        <translation>
            <numerusform>Ce qui peut être fait d’ici. Retour à Surveillance après %n minute sans clavier ni souris.</numerusform>
            <numerusform>Ce qui peut être fait d’ici. Retour à Surveillance après %n minutes sans clavier ni souris.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::Announcer</name>
    <message>
        <source>New alarm %1: %2</source>
        <translation>Nouvelle alarme %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ui::ArmBadge</name>
    <message>
        <source>This controller is armed: press to disarm.</source>
        <translation>Ce contrôleur est armé&#xa0;: appuyer pour désarmer.</translation>
    </message>
    <message>
        <source>ARMED · %1 s</source>
        <translation>ARMÉ · %1 s</translation>
    </message>
    <message numerus="yes">
        <source>Armed for %n more second(s). Press to disarm.</source>
        <translation>
            <numerusform>Armé encore %n seconde. Appuyer pour désarmer.</numerusform>
            <numerusform>Armé encore %n secondes. Appuyer pour désarmer.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::BackupAge</name>
    <message>
        <source>No backup</source>
        <translation>Aucune sauvegarde</translation>
    </message>
    <message numerus="yes">
        <source>Backup %n hour(s) old</source>
        <translation>
            <numerusform>Sauvegarde de %n heure</numerusform>
            <numerusform>Sauvegarde de %n heures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Backup %n day(s) old</source>
        <translation>
            <numerusform>Sauvegarde de %n jour</numerusform>
            <numerusform>Sauvegarde de %n jours</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Old backup: %n day(s)</source>
        <translation>
            <numerusform>Sauvegarde ancienne : %n jour</numerusform>
            <numerusform>Sauvegarde ancienne : %n jours</numerusform>
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
        <translation>HLOCK est activé sur %1&#xa0;: le boîtier de programmation est verrouillé, sauf son arrêt d’urgence.</translation>
    </message>
    <message>
        <source>Release HLOCK</source>
        <translation>Annuler HLOCK</translation>
    </message>
    <message numerus="yes">
        <source>The journal works again. %n record(s) were lost.</source>
        <translation>
            <numerusform>Le journal fonctionne à nouveau. %n entrée a été perdue.</numerusform>
            <numerusform>Le journal fonctionne à nouveau. %n entrées ont été perdues.</numerusform>
        </translation>
    </message>
    <message>
        <source>The journal was damaged. It was kept as %1, and a new one was begun.</source>
        <translation>Le journal était endommagé. Il a été conservé sous %1, et un nouveau a été commencé.</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Level: %1</source>
        <translation>Niveau&#xa0;: %1</translation>
    </message>
    <message>
        <source>HLOCK is on</source>
        <translation>HLOCK est activé</translation>
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
        <translation>La démo n’a pas pu être démarrée&#xa0;: %1.</translation>
    </message>
    <message>
        <source>About Pendesk</source>
        <translation>À propos de Pendesk</translation>
    </message>
    <message>
        <source>Pendesk %1

A teach and monitor desk for Yaskawa robot controllers.
Free software under the GNU General Public License, version 3 or later.

HOLD is a software hold over the network, not a safety function.</source>
        <translation>Pendesk %1

Un poste d’apprentissage et de surveillance pour contrôleurs de robots Yaskawa.
Logiciel libre sous licence publique générale GNU (GNU General Public License), version 3 ou ultérieure.

HOLD est un HOLD logiciel par le réseau, pas une fonction de sécurité.</translation>
    </message>
    <message>
        <source>There is no connection.</source>
        <translation>Il n’y a pas de connexion.</translation>
    </message>
    <message>
        <source>The connection is open.</source>
        <translation>La connexion est ouverte.</translation>
    </message>
    <message>
        <source>No controller is chosen.</source>
        <translation>Aucun contrôleur n’est choisi.</translation>
    </message>
    <message>
        <source>No controller is chosen: connect first.</source>
        <translation>Aucun contrôleur n’est choisi&#xa0;: se connecter d’abord.</translation>
    </message>
    <message>
        <source>%1 requests/s</source>
        <translation>%1 requêtes/s</translation>
    </message>
    <message>
        <source>Something is unfinished</source>
        <translation>Quelque chose n’est pas terminé</translation>
    </message>
    <message>
        <source>Go on and lose it</source>
        <translation>Continuer malgré la perte</translation>
    </message>
    <message>
        <source>HLOCK is still on at %1: the pendant stays locked out if you go on.</source>
        <translation>HLOCK est encore activé sur %1&#xa0;: le boîtier reste verrouillé si vous continuez.</translation>
    </message>
    <message>
        <source>Release HLOCK and go on</source>
        <translation>Désactiver HLOCK et continuer</translation>
    </message>
    <message>
        <source>Go on and leave it on</source>
        <translation>Continuer et le laisser activé</translation>
    </message>
</context>
<context>
    <name>ui::NavigationRail</name>
    <message>
        <source>CONTROLLERS</source>
        <translation>CONTRÔLEURS</translation>
    </message>
    <message>
        <source>PAGES</source>
        <translation>PAGES</translation>
    </message>
    <message>
        <source>CONNECTION</source>
        <translation>CONNEXION</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
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
        <translation>Liaison</translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>Aucun contrôleur</translation>
    </message>
    <message>
        <source>Link · %1 ago</source>
        <translation>Liaison · il y a %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>PERDUE</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>checking…</source>
        <translation>vérification…</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>Servo</source>
        <translation>Servo</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>HOLD</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
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
            <numerusform>%n autre dans Parc</numerusform>
            <numerusform>%n autres dans Parc</numerusform>
        </translation>
    </message>
    <message>
        <source>No controller</source>
        <translation>Aucun contrôleur</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
</context>
<context>
    <name>values</name>
    <message>
        <source>none</source>
        <translation>néant</translation>
    </message>
    <message>
        <source>number</source>
        <translation>nombre</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>axes</translation>
    </message>
    <message>
        <source>conveyor files</source>
        <translation>fichiers de convoyeur</translation>
    </message>
    <message>
        <source>robots and stations</source>
        <translation>robots et stations</translation>
    </message>
    <message>
        <source>signed number</source>
        <translation>nombre signé</translation>
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
        <translation>robots, stations et bases</translation>
    </message>
    <message>
        <source>control group, low and high axes</source>
        <translation>groupe d’axes, axes inférieurs et supérieurs</translation>
    </message>
    <message>
        <source>control group, minimum and maximum axes</source>
        <translation>groupe d’axes, axes minimum et maximum</translation>
    </message>
    <message>
        <source>control group, minimum and maximum X Y Z</source>
        <translation>groupe d’axes, X Y Z minimum et maximum</translation>
    </message>
    <message>
        <source>axes of two control groups</source>
        <translation>axes de deux groupes d’axes</translation>
    </message>
    <message>
        <source>two sets of axes of a control group</source>
        <translation>deux jeux d’axes d’un groupe d’axes</translation>
    </message>
    <message>
        <source>axes of a control group and a number</source>
        <translation>axes d’un groupe d’axes et un nombre</translation>
    </message>
    <message>
        <source>control group and a number</source>
        <translation>groupe d’axes et un nombre</translation>
    </message>
    <message>
        <source>unknown type %1</source>
        <translation>type inconnu %1</translation>
    </message>
    <message>
        <source>front</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>back</source>
        <translation>arrière</translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation>bras supérieur</translation>
    </message>
    <message>
        <source>lower arm</source>
        <translation>bras inférieur</translation>
    </message>
    <message>
        <source>flip</source>
        <translation>flip</translation>
    </message>
    <message>
        <source>no flip</source>
        <translation>sans flip</translation>
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
        <translation>redondant avant</translation>
    </message>
    <message>
        <source>redundant back</source>
        <translation>redondant arrière</translation>
    </message>
    <message>
        <source>previous step&apos;s form</source>
        <translation>configuration du pas précédent</translation>
    </message>
    <message>
        <source>this form</source>
        <translation>cette configuration</translation>
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
        <translation>impulsion</translation>
    </message>
    <message>
        <source>base frame</source>
        <translation>repère base</translation>
    </message>
    <message>
        <source>robot frame</source>
        <translation>repère robot</translation>
    </message>
    <message>
        <source>user frame</source>
        <translation>repère utilisateur</translation>
    </message>
    <message>
        <source>tool frame</source>
        <translation>repère outil</translation>
    </message>
    <message>
        <source>group %1</source>
        <translation>groupe %1</translation>
    </message>
    <message numerus="yes">
        <source>… (%n more characters)</source>
        <translation>
            <numerusform>… (%n caractère de plus)</numerusform>
            <numerusform>… (%n caractères de plus)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>variables::Sentences</name>
    <message>
        <source>Line %1: a cell begins with a quotation mark and does not end with one.</source>
        <translation>Ligne %1&#xa0;: une cellule commence par un guillemet et ne se termine pas par un guillemet.</translation>
    </message>
    <message>
        <source>Line %1: there is text behind the quotation mark that ends a cell.</source>
        <translation>Ligne %1&#xa0;: il y a du texte après le guillemet qui termine une cellule.</translation>
    </message>
    <message>
        <source>The file is not UTF-8: save it as “CSV UTF-8” and try again.</source>
        <translation>Le fichier n’est pas en UTF-8&#xa0;: l’enregistrer en «&#xa0;CSV UTF-8&#xa0;» et réessayer.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>%1 is out of range: it must be from %2 to %3.</source>
        <translation>%1 est hors de la plage&#xa0;: de %2 à %3.</translation>
    </message>
    <message>
        <source>“%1” is not a whole number: write it without decimals and separators.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre entier&#xa0;: l’écrire sans décimales ni séparateurs.</translation>
    </message>
    <message>
        <source>%1 does not go into a real: that is 0, or from ±1.18e-38 to ±3.40e+38.</source>
        <translation>%1 n’entre pas dans un réel&#xa0;: 0, ou de ±1.18e-38 à ±3.40e+38.</translation>
    </message>
    <message>
        <source>not a number</source>
        <translation>pas un nombre</translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre entier.</translation>
    </message>
    <message numerus="yes">
        <source>“%1” is too fine: %n decimal(s) are kept.</source>
        <translation>
            <numerusform>«&#xa0;%1&#xa0;» est trop précis&#xa0;: %n décimale est conservée.</numerusform>
            <numerusform>«&#xa0;%1&#xa0;» est trop précis&#xa0;: %n décimales sont conservées.</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is not a variable. Write its letter and its number, such as B007.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une variable. Écrire sa lettre et son numéro, par exemple B007.</translation>
    </message>
    <message>
        <source>There is no %1: this controller has %2 to %3.</source>
        <translation>%1 n’existe pas&#xa0;: ce contrôleur a %2 à %3.</translation>
    </message>
    <message>
        <source>“%1” is not a range: it must go from a lower to a higher number of one kind.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une plage&#xa0;: elle doit aller d’un numéro inférieur à un numéro supérieur du même type.</translation>
    </message>
    <message>
        <source>“%1” is not a type that %2 has.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un type que possède %2.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>column: reason</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is missing, and no value of this type was read.</source>
        <translation>%1 est absent, et aucune valeur de ce type n’a été lue.</translation>
    </message>
    <message>
        <source>The type is missing, and none was read.</source>
        <translation>Le type est absent, et aucun n’a été lu.</translation>
    </message>
    <message>
        <source>The variable is missing.</source>
        <translation>La variable est absente.</translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation>%1 ne peut être que lu.</translation>
    </message>
    <message>
        <source>%1 stands in line %2 already.</source>
        <translation>%1 figure déjà à la ligne %2.</translation>
    </message>
    <message>
        <source>The value is missing.</source>
        <translation>La valeur est absente.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>variable: reason</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>The column “%1” stands there twice.</source>
        <translation>La colonne «&#xa0;%1&#xa0;» figure deux fois.</translation>
    </message>
    <message>
        <source>The header is missing: the first line must name the columns “variable” and “value”.</source>
        <translation>L’en-tête est absent&#xa0;: la première ligne doit nommer les colonnes «&#xa0;variable&#xa0;» et «&#xa0;value&#xa0;».</translation>
    </message>
    <message>
        <source>There is neither a column “value” nor “axis 1”.</source>
        <translation>Il n’y a ni colonne «&#xa0;value&#xa0;» ni colonne «&#xa0;axis 1&#xa0;».</translation>
    </message>
    <message>
        <source>The line has more cells than the header.</source>
        <translation>La ligne a plus de cellules que l’en-tête.</translation>
    </message>
    <message>
        <source>A block without a header has one or two columns.</source>
        <translation>Un bloc sans en-tête a une ou deux colonnes.</translation>
    </message>
    <message>
        <source>The text cannot be sent: %1.</source>
        <translation>Le texte ne peut pas être envoyé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The text must not hold the character NUL, which ends it.</source>
        <translation>Le texte ne doit pas contenir le caractère NUL, qui le termine.</translation>
    </message>
    <message>
        <source>The text takes %1 bytes; there is room for %2.</source>
        <translation>Le texte occupe %1 octets&#xa0;; il y a de la place pour %2.</translation>
    </message>
    <message>
        <source>A position is not written as one text.</source>
        <translation>Une position ne s’écrit pas comme un seul texte.</translation>
    </message>
    <message>
        <source>a real number</source>
        <translation>un nombre réel</translation>
    </message>
    <message numerus="yes">
        <source>up to %n byte(s)</source>
        <translation>
            <numerusform>jusqu’à %n octet</numerusform>
            <numerusform>jusqu’à %n octets</numerusform>
        </translation>
    </message>
    <message>
        <source>pulse</source>
        <translation>impulsion</translation>
    </message>
</context>
<context>
    <name>widgets::ArmControl</name>
    <message>
        <source>Hold for 1 s to arm</source>
        <translation>Maintenir 1 s pour armer</translation>
    </message>
    <message>
        <source>Why not?</source>
        <translation>Pourquoi pas&#xa0;?</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Désarmer</translation>
    </message>
    <message>
        <source>Nobody is inside the fence</source>
        <translation>Personne n’est à l’intérieur de l’enceinte de protection</translation>
    </message>
    <message>
        <source>I see the robot, or somebody who does</source>
        <translation>Je vois le robot, ou quelqu’un d’autre le voit</translation>
    </message>
    <message>
        <source>An emergency stop is within reach there</source>
        <translation>Un arrêt d’urgence est à portée de main là-bas</translation>
    </message>
    <message>
        <source>Armed: start, servo on and moves are possible. It drops after a minute without key or mouse.</source>
        <translation>Armé&#xa0;: démarrage, Servo ON et mouvements sont possibles. L’armement cesse après une minute sans clavier ni souris.</translation>
    </message>
    <message>
        <source>Disarmed at %1: %2.</source>
        <translation>Désarmé à %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Tick all three first.</source>
        <translation>Cocher d’abord les trois cases.</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
</context>
<context>
    <name>widgets::CellEditor</name>
    <message>
        <source>live: %1</source>
        <translation>en direct&#xa0;: %1</translation>
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
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>widgets::ControllerTile</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
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
        <translation>Lignes des deux versions</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Older</source>
        <translation>Plus ancien</translation>
    </message>
    <message>
        <source>Newer</source>
        <translation>Plus récent</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::GoToEdit</name>
    <message>
        <source>Go to</source>
        <translation>Aller à</translation>
    </message>
    <message>
        <source>Go to…  Ctrl+G</source>
        <translation>Aller à…  Ctrl+G</translation>
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
        <translation>HOLD (logiciel)</translation>
    </message>
    <message>
        <source>software hold · Pause key</source>
        <translation>HOLD logiciel · touche Pause</translation>
    </message>
</context>
<context>
    <name>widgets::JobView</name>
    <message>
        <source>Job text</source>
        <translation>Texte du job</translation>
    </message>
</context>
<context>
    <name>widgets::JogPad</name>
    <message>
        <source>Jog %1 forward</source>
        <translation>Déplacement manuel %1 avant</translation>
    </message>
    <message>
        <source>Jog %1 back</source>
        <translation>Déplacement manuel %1 arrière</translation>
    </message>
</context>
<context>
    <name>widgets::LogicStrip</name>
    <message>
        <source>The watched signals over the last minute</source>
        <translation>Les signaux suivis pendant la dernière minute</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
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
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>widgets::OrderButton</name>
    <message>
        <source>Why not?</source>
        <translation>Pourquoi pas&#xa0;?</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Conditions</translation>
    </message>
    <message>
        <source>Conditions of: %1</source>
        <translation>Conditions de&#xa0;: %1</translation>
    </message>
    <message>
        <source>Pending…</source>
        <translation>En attente…</translation>
    </message>
</context>
<context>
    <name>widgets::Plot</name>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Nothing is plotted.</source>
        <translation>Aucune courbe.</translation>
    </message>
</context>
<context>
    <name>widgets::Plottables</name>
    <message>
        <source>Add to trend: %1</source>
        <translation>Ajouter à la tendance&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>widgets::Question</name>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
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
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>widgets::Segments</name>
    <message>
        <source>%1: %2</source>
        <comment>what is chosen: the choice</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>widgets::Sparkline</name>
    <message>
        <source>Round trips of the last 60 seconds: none yet.</source>
        <translation>Allers-retours des 60 dernières secondes&#xa0;: aucun pour l’instant.</translation>
    </message>
    <message>
        <source>Round trips of the last 60 seconds: longest %1 ms, lost tries in %2 s.</source>
        <translation>Allers-retours des 60 dernières secondes&#xa0;: le plus long %1 ms, essais perdus pendant %2 s.</translation>
    </message>
</context>
<context>
    <name>widgets::ToolPathView</name>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Tool path, %1 view</source>
        <translation>Trajectoire de l’outil, vue %1</translation>
    </message>
    <message>
        <source>No position in the base frame was read yet.</source>
        <translation>Aucune position dans le repère base n’a encore été lue.</translation>
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
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
</TS>
