# bash completion for whirl

# Names that `whirl describe` knows, from the command itself.
_whirl_names() {
    "$1" describe 2>/dev/null | sed -n 's/^  \([A-Za-z0-9_-]*\) .*/\1/p'
}

# Files with one of the given endings, and folders.
_whirl_files() {
    local word=$1 ending
    shift
    compopt -o filenames 2>/dev/null
    COMPREPLY=()
    mapfile -t COMPREPLY < <(
        compgen -d -- "$word"
        for ending in "$@"; do compgen -f -X "!*.$ending" -- "$word"; done
    )
}

_whirl_options() {
    case $1 in
    run) echo '-o --output= --set= --threads= --json --resume --force --refine --refine= --quiet --help' ;;
    verify) echo '--points= --method= --revolutions= --set= --threads= --json --quiet --help' ;;
    report) echo '-o --output= --claims= --gnuplot= --explorer= --units= --quiet --help' ;;
    export) echo '--csv= --help' ;;
    show) echo '--json --help' ;;
    check | describe | help) echo '--help' ;;
    *) echo '--help --version' ;;
    esac
}

_whirl() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=
    [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]}
    # bash splits --option=value at the '='
    if [ "$word" = = ]; then
        word=
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    case $before in
    -o | --output)
        if [ "$command" = run ]; then _whirl_files "$word" h5; else _whirl_files "$word"; fi
        return
        ;;
    --csv) _whirl_files "$word"; return ;;
    --claims) _whirl_files "$word" yaml yml; return ;;
    --explorer) mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    --gnuplot) mapfile -t COMPREPLY < <(compgen -c -- "$word"); return ;;
    --set | --threads | --points | --method | --revolutions) return ;;
    esac
    if [[ $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_whirl_options "$command")" -- "$word")
        [[ ${COMPREPLY[0]-} == *= ]] && compopt -o nospace 2>/dev/null
        return
    fi
    case $command in
    '') mapfile -t COMPREPLY < <(compgen -W 'run verify check describe report show export help' -- "$word") ;;
    run | verify | check) _whirl_files "$word" yaml yml ;;
    report | show | export) _whirl_files "$word" h5 ;;
    help) mapfile -t COMPREPLY < <(compgen -W 'run verify check describe report show export' -- "$word") ;;
    describe) mapfile -t COMPREPLY < <(compgen -W "$(_whirl_names "${COMP_WORDS[0]}")" -- "$word") ;;
    esac
}

complete -F _whirl whirl
