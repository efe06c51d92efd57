# bash completion for whirl

# Names that `whirl describe` lists, from the command itself: all, or those of one part ("methods of integration").
_whirl_names() {
    "$1" describe 2>/dev/null | awk -v part="${2-}" '
        /^[a-z].*:$/     { now = substr($0, 1, length($0) - 1); next }
        /^  [A-Za-z0-9_]/ { if (part == "" || part == now) print $1 }'
}

# The keys of one name that `whirl describe NAME` shows below the head of its table.
_whirl_keys() {
    "$1" describe "$2" 2>/dev/null | sed -n '/^  name  /,$ s/^  \([a-z][A-Za-z0-9_]*\) .*/\1/p' | grep -vx name
}

# The words that a key takes, as `whirl describe NAME` shows them: one|other.
_whirl_choices() { # WHIRL NAME.KEY
    "$1" describe "${2%.*}" 2>/dev/null |
        awk -v key="${2##*.}" '$1 == key && /^  [a-z].*[|]/ { gsub(/[|]/, " ", $NF); print $NF }'
}

# The case among the words of the command line, or nothing.
_whirl_case() {
    local word
    for word in "${COMP_WORDS[@]:2}"; do
        case $word in *.yaml | *.yml) [ -r "$word" ] && { echo "$word"; return; } ;; esac
    done
}

# Names in a mapping of a case that is written with indentation.
_whirl_members() {
    awk -v name="$2:" '
        /^ *(#|$)/         { next }
                           { match($0, /^ */); indent = RLENGTH }
        inside && indent <= outer { exit }
        inside             { if (!inner) inner = indent
                             if (indent == inner) { sub(/:.*/, "", $1); print $1 }
                             next }
        $1 == name         { inside = 1; outer = indent }' "$1" 2>/dev/null
}

# What --set takes: parameters of the case, and keys of its stations, its elements and how it is integrated.
_whirl_settings() {
    local whirl=$1 case=$2 name key
    [ -n "$case" ] || return
    _whirl_members "$case" parameters | sed 's/$/=/'
    for name in $(_whirl_members "$case" stations); do
        for key in $(_whirl_keys "$whirl" station); do echo "$name.$key="; done
    done
    for name in $(_whirl_names "$whirl" elements); do
        grep -qE "^ *- *$name\b" "$case" || continue
        for key in $(_whirl_keys "$whirl" "$name"); do echo "$name.$key="; done
    done
    for key in $(_whirl_keys "$whirl" integrate); do echo "integrate.$key="; done
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

_whirl_words() { # WORD NAMES...
    mapfile -t COMPREPLY < <(compgen -W "${*:2}" -- "$1")
    [[ ${COMPREPLY[0]-} == *= ]] && compopt -o nospace 2>/dev/null
}

_whirl_options() {
    case $1 in
    new | import) echo '-o --output= --force --help' ;;
    run)
        echo '-o --output= --set= --threads= --json --json=full --resume --force --refine --refine= --shard= --max-time= --quiet' \
            '--help'
        ;;
    merge) echo '-o --output= --set= --threads= --json --json=full --force --refine --refine= --max-time= --quiet --help' ;;
    verify) echo '--points= --method= --revolutions= --set= --threads= --json --quiet --help' ;;
    report) echo '-o --output= --claims= --gnuplot= --explorer= --units= --lateral --torsional --weasyprint= --force --quiet --help' ;;
    figure) echo '-o --output= --list --with= --columns= --format= --units= --log= --panels= --gnuplot= --force --help' ;;
    table) echo '-o --output= --list --format= --units= --force --help' ;;
    show) echo '--json --json=full --help' ;;
    export) echo '--csv= --mat= --force --help' ;;
    check) echo '--set= --figure= --force --help' ;;
    balance) echo '--json --units= --sheet= --format= --help' ;;
    bearing) echo '-o --output= --json --units= --sheet= --format= --csv= --table= --over-frequency --at= --figure= --gnuplot= --threads= --force --quiet --help' ;;
    describe | help) echo '--help' ;;
    *) echo '--help --version' ;;
    esac
}

_whirl() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= whirl=${COMP_WORDS[0]}
    [ "$COMP_CWORD" -gt 1 ] && command=${COMP_WORDS[1]}
    # bash splits --option=value and NAME=VALUE at the '='
    local split='' of_key=''
    if [ "$word" = = ]; then
        word='' split=yes
    elif [ "$before" = = ]; then
        before=${COMP_WORDS[COMP_CWORD - 2]} split=yes
    fi
    [[ $split && $before != -* ]] && of_key=yes
    case $before in
    -o | --output)
        case $command in
        run | merge) _whirl_files "$word" h5 ;;
        new | import) _whirl_files "$word" yaml yml ;;
        table) _whirl_files "$word" txt csv tex json ;;
        *) _whirl_files "$word" ;;
        esac
        return
        ;;
    --csv | --mat) _whirl_files "$word"; return ;;
    --table) _whirl_files "$word" yaml yml; return ;;
    --claims) _whirl_files "$word" yaml yml; return ;;
    --explorer) mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    --gnuplot | --weasyprint) mapfile -t COMPREPLY < <(compgen -c -- "$word"); return ;;
    --set) _whirl_words "$word" "$(_whirl_settings "$whirl" "$(_whirl_case)")"; return ;;
    --method | integrate.method) _whirl_words "$word" "$(_whirl_names "$whirl" 'methods of integration')"; return ;;
    --threads) _whirl_words "$word" "$(seq "$(nproc 2>/dev/null || echo 1)")"; return ;;
    *.*) [ "$of_key" ] && { _whirl_words "$word" "$(_whirl_choices "$whirl" "$before")"; return; } ;;
    --format) [[ $command == @(table|balance|bearing) ]] && _whirl_words "$word" 'text csv latex markdown json'; return ;;
    --figure) _whirl_words "$word" 'curves sommerfeld locus'; return ;;
    --at | --points | --revolutions | --refine | --shard | --max-time | --units | --sheet) return ;;
    esac
    [ "$of_key" ] && return # a number
    if [[ $word == -* ]]; then
        _whirl_words "$word" "$(_whirl_options "$command")"
        return
    fi
    case $command in
    '') _whirl_words "$word" 'new import run merge verify check describe report figure table show export balance bearing help' ;;
    new) _whirl_words "$word" "$("$whirl" new --help | sed -n '/Kinds:/,/^$/s/^  \([a-z][a-z]*\)  .*/\1/p')" ;;
    import) _whirl_files "$word" toml json ;;
    run | merge | verify | check | balance | bearing) _whirl_files "$word" yaml yml ;;
    report | figure | show | export) _whirl_files "$word" h5 ;;
    table)
        case $before in
        *.h5) _whirl_words "$word" "$("$whirl" table "$before" --list 2>/dev/null | awk '{ print $1 }')" ;;
        *) _whirl_files "$word" h5 ;;
        esac
        ;;
    describe) _whirl_words "$word" "$(_whirl_names "$whirl")" ;;
    help) _whirl_words "$word" 'new import run merge verify check describe report figure table show export balance bearing' ;;
    esac
}

complete -F _whirl whirl whirl-mpi
