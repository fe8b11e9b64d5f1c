# Completion of quicksand for bash: the program itself says what can stand at the cursor.
_quicksand() {
    local line=${COMP_LINE:0:COMP_POINT} words answer candidate
    read -ra words <<<"${line//\\ /$'\a'}" # a blank behind a backslash divides no words
    words=("${words[@]//$'\a'/ }")
    [[ $line == *[[:blank:]] ]] && words+=("")
    mapfile -t answer < <("${1/#\~/$HOME}" complete "${words[@]:1}" 2>/dev/null)

    local before=${words[-1]%"$2"} # bash itself replaces only what stands behind = and :
    for candidate in "${answer[@]:1}"; do
        candidate=${candidate%%$'\t'*}
        COMPREPLY+=("${candidate#"$before"}")
    done
    [[ ${COMPREPLY[0]} == *[.=] ]] && compopt -o nospace

    local files=()
    case ${answer[0]} in
        all) mapfile -t files < <(compgen -f -- "$2") ;;
        folders) mapfile -t files < <(compgen -d -- "$2") ;;
        scenes) mapfile -t files < <(compgen -d -- "$2"; compgen -f -X '!*.toml' -- "$2") ;;
    esac
    [[ ${#files[@]} -gt 0 ]] && compopt -o filenames && COMPREPLY+=("${files[@]}")
}
complete -F _quicksand quicksand
