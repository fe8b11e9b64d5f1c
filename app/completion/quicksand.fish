# Completion of quicksand for fish: the program itself says what can stand at the cursor.
function __quicksand_complete
    set -l before (commandline -opc)
    set -l word (commandline -ct)
    set -l program $before[1]
    set -e before[1]
    set -l answer ($program complete $before "$word" 2>/dev/null)
    set -l files $answer[1]
    set -e answer[1]
    printf '%s\n' $answer
    switch "$files"
        case all
            __fish_complete_path "$word"
        case folders
            __fish_complete_directories "$word" ''
        case scenes
            __fish_complete_suffix .toml
    end
end
complete -c quicksand -f -a '(__quicksand_complete)'
