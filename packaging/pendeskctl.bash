# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: The Pendesk authors
# Completion of pendeskctl for bash.
_pendeskctl() {
    local word=${COMP_WORDS[COMP_CWORD]} verb=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD-1]}
    local controller='--host --port --file-port --model --profile --timeout'
    local words="$controller --numbering --json --yes --quiet --log --help"
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
        words='status info alarms position jobs io registers var files check backup verify show xref calls unused compare restore
            watch decode
            --help --version'
    elif [ "$COMP_CWORD" -eq 2 ] && [[ $word != -* ]]; then
        case $verb in
            io|registers|var) words='get set' ;;
            files) words='ls get put rm' ;;
            check|backup|verify|show|xref|calls|unused|compare|restore) compopt -o default; return ;;
        esac
    else
        case $verb:$before in
            alarms:--history) words='major minor user system offline'; verb= ;;
            *:--to) compopt -o dirnames; return ;;
            *:--numbering) words='0 1'; verb= ;;
            decode:--port) words='10040 10041'; verb= ;;
            decode:--encoding) words='ISO-8859-1 UTF-8 Shift_JIS GBK Big5 EUC-KR'; verb= ;;
            *:--model) words='dx100 dx200 fs100 yrc1000 yrc1000micro'; verb= ;;
            files:*|check:*|compare:*|show:*|xref:*|calls:*|unused:*) [[ $word == -* ]] || { compopt -o default; return; } ;;
        esac
    fi
    if [ "$COMP_CWORD" -gt 2 ] || [[ $COMP_CWORD -eq 2 && $word == -* ]]; then
        case $verb in
            status) words="$controller --json --help" ;;
            alarms) words="$words --history" ;;
            position) words="$words --pulse" ;;
            files) words="$words --to --replace" ;;
            backup) words="$words --keep --keep-days --all-prm" ;;
            check) words='--encoding --json --yes --quiet --log --help' ;;
            show|xref|calls|unused) words='--json --encoding --yes --quiet --log --help' ;;
            verify) words='--json --yes --quiet --log --help' ;;
            compare) words="$words --noise" ;;
            restore) words="$words --dry-run" ;;
            watch) words="$words --every --count" ;;
            decode) words='--text --reply-to --port --encoding --model --help' ;;
        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -F _pendeskctl pendeskctl
