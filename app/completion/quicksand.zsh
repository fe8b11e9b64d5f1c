#compdef quicksand
# Completion of quicksand for zsh: the program itself says what can stand at the cursor.
_quicksand() {
    local -a answer open closed
    local line word
    answer=("${(@f)$(${(Q)~words[1]} complete "${(@Q)words[2,CURRENT-1]}" "$PREFIX" 2>/dev/null)}")
    for line in "${(@)answer[2,-1]}"; do
        word=${line%%$'\t'*}
        case $word in
            *[.=]) open+=("${word//:/\\:}:${line#*$'\t'}") ;;
            *) closed+=("${word//:/\\:}:${${line#$word}#$'\t'}") ;;
        esac
    done
    (( $#open )) && _describe -t keys key open -S ''
    (( $#closed )) && _describe -t words word closed
    compset -P '--*='
    case $answer[1] in
        all) _files ;;
        folders) _files -/ ;;
        scenes) _files -g '*.toml' ;;
    esac
}
_quicksand "$@"
