# Completion of thelma for bash: options, parameter files, studies and the entries of --set, --sweep.

# Section/Entry= for every entry with its default.
_thelma_entries()
{
  thelma --defaults 2>/dev/null | awk '
    $1 == "subsection" { sub(/^ *subsection /, ""); path[++depth] = $0 }
    $1 == "end" { --depth }
    $1 == "set" {
      sub(/^ *set /, ""); sub(/ *=.*/, "")
      prefix = ""
      for (i = 1; i <= depth; ++i) prefix = prefix path[i] "/"
      print prefix $0 "="
    }'
}

_thelma()
{
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local IFS=$'\n'
  case $before in
  --set | --sweep)
    local entry
    for entry in $(_thelma_entries); do
      [[ $entry != "${word#[\"\']}"* ]] || COMPREPLY+=("\"$entry")
    done
    compopt -o nospace
    return
    ;;
  --output | --restart)
    mapfile -t COMPREPLY < <(compgen -d -- "$word")
    return
    ;;
  esac
  case $word in
  -*)
    mapfile -t COMPREPLY < <(compgen -W $'--set\n--sweep\n--ranks-per-case\n--output\n--restart\n--estimate\n--check\n--material-point\n--list\n--defaults\n--version\n--help' -- "$word")
    ;;
  @*)
    mapfile -t COMPREPLY < <(compgen -P @ -f -X '!*.study' -- "${word#@}"
      compgen -P @ -d -S / -- "${word#@}")
    ;;
  *)
    mapfile -t COMPREPLY < <(compgen -f -X '!*.prm' -- "$word"
      compgen -d -S / -- "$word")
    compopt -o filenames
    ;;
  esac
}

complete -F _thelma thelma
