#!/bin/sh
# A controller in POSIX shell: drive until the bumper reports a stall, then back off and turn.
# The protocol is docs/process-protocol.md; messages hold no blanks, so patterns can read them.

recovering=0

while IFS= read -r message; do
    case $message in
    '{"type":"hello"'*) echo '{"type":"hello","protocol":1}' ;;
    '{"type":"reset"'*) recovering=0 ;;
    '{"type":"decide"'*)
        number=${message#*'"number":'}
        number=${number%%,*}
        case $message in *'"stalled":true'*) recovering=9 ;; esac
        if [ "$recovering" -gt 5 ]; then
            action='{"kind":"backward","translation":-0.3}' situation=backing
        elif [ "$recovering" -gt 0 ]; then
            action='{"kind":"left","rotation":0.4}' situation=turning
        else
            action='{"kind":"forward","translation":0.3}' situation=driving
        fi
        [ "$recovering" -gt 0 ] && recovering=$((recovering - 1))
        echo "{\"type\":\"action\",\"number\":$number,\"action\":$action,\"situation\":\"$situation\"}"
        ;;
    '{"type":"close"'*) exit 0 ;;
    esac
done
