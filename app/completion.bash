# bash completion of ordo, made by: ordo completion
_ordo() {
    local word="${COMP_WORDS[COMP_CWORD]}" words
    if [ "$COMP_CWORD" -eq 1 ]; then
        mapfile -t COMPREPLY < <(compgen -W "list run check accept history table plot oracle solve stability basis fit completion --help --version" -- "$word")
        return
    fi
    case "${COMP_WORDS[1]}" in
        list) words="--help scenes solvers oracles norms studies schema" ;;
        run) words="--help --out --jobs --time --set --no-cache --why-not-cached --verbose" ;;
        check) words="--help --against --times --verbose --junit --annotations --summary" ;;
        accept) words="--help --because --into" ;;
        history) words="--help --format" ;;
        table) words="--help --rank --format" ;;
        plot) words="--help --out --against --reach --format" ;;
        oracle) words="--help --set --t --constants --plot --format --x --grid --points --cells" ;;
        solve) words="--help --solver --set --t --out --format" ;;
        stability) words="--help --solver --set --motion --crossings --from --to" ;;
        basis) words="--help --basis --show --option --cells --margin --ppc --translate --stretch --plot --format" ;;
        fit) words="--help --abscissa --error --value --formal --format" ;;
        *) words="" ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word"; compgen -f -- "$word")
}
complete -o filenames -F _ordo ordo
