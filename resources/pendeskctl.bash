# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
# Completion of pendeskctl for bash.
_pendeskctl() {
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD-1]}
    local words='--host --port --file-port --profile --numbering --timeout --json --yes --quiet --help'
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        words='status info alarms position jobs io registers var files backup verify compare restore watch decode'
    elif [ "$COMP_CWORD" -eq 2 ] && [[ $word != -* ]]; then
        case $verb in
            io|registers|var) words='get set' ;;
            files) words='ls get put rm' ;;
            backup|verify|compare|restore) compopt -o default; return ;;
        esac
    else
        case $verb:$before in
            alarms:--history) words='major minor user system offline' ;;
            *:--to) compopt -o dirnames; return ;;
            *:--numbering) words='0 1' ;;
            files:*|compare:*) [[ $word == -* ]] || { compopt -o default; return; } ;;
        esac
        case $verb in
            alarms) words="$words --history" ;;
            position) words="$words --pulse" ;;
            files) words="$words --to --replace" ;;
            backup) words="$words --keep --keep-days" ;;
            compare) words="$words --noise" ;;
            restore) words="$words --dry-run" ;;
            watch) words="$words --every --count" ;;
        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -F _pendeskctl pendeskctl
