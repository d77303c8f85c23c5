# Completion of mechc for bash. Unlike a script of click, it offers files beside names.

%(complete_func)s() {
    local IFS=$'\n' type value answer
    answer=$(env COMP_WORDS="${COMP_WORDS[*]}" COMP_CWORD="$COMP_CWORD" \
        %(complete_var)s=bash_complete "$1" 2> /dev/null)
    while IFS=',' read -r type value; do
        case $type in
            plain) COMPREPLY+=("$value") ;;
            file)
                compopt -o filenames
                mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$value")
                ;;
        esac
    done <<< "$answer"
}

complete -F %(complete_func)s %(prog_name)s
