# Completion of coapt, coapt-farm, coapt-live and coapt-server for bash. Commands and options come from the program's own --help, so that none is
# missing; what options take stands here.

# Options of a command: the first words of lines that begin with a dash.
_coapt_options() {
  "$@" --help 2>/dev/null | awk '/^ +-/ { gsub(",", "\n", $1); print $1 }'
}

# Its subcommands.
_coapt_subcommands() {
  "$@" --help 2>/dev/null | awk '/^[^ ]/ { listed = /^Subcommands:/; next } listed && /^  [a-z]/ { print $1 }'
}

# Presets by name, from coapt beside whichever program it is.
_coapt_presets() {
  "${1%-live}" presets 2>/dev/null | sed 's/:.*//'
}

# What follows an option; nothing: a file, or anything.
_coapt_values() {
  case $1 in
    --method) echo fast thesis ;;
    --membrane) echo springs continuum ;;
    --units) echo mm cm m ;;
    --label) echo anterior= posterior= annulus= ;;
    --align) echo auto none rigid ;;
    --side) echo atrial middle ;;
    --known) echo slack tips prestretch hidden ;;
    --protocol) echo lookup-clamped lookup-extended closed optimum ;;
    --displacement-step) echo 1 2 3 6 ;;
    --device) echo haply ;;
    --exam) echo A B ;;
    --server) echo http://127.0.0.1:8080 ;;
    --forbid)
      echo annuloplasty papillary_approximation neochorda chordal_length_change chordal_excision chordal_transfer \
        edge_to_edge leaflet_resection \
        annuloplasty:own annuloplasty:generic-classic annuloplasty:generic-etlogix-like annuloplasty:generic-geoform-like \
        papillary_approximation:anterolateral papillary_approximation:posteromedial \
        papillary_approximation:ipsilateral_trigone papillary_approximation:saddle_peak \
        papillary_approximation:annulus_point neochorda:anterior neochorda:posterior \
        edge_to_edge:stitch edge_to_edge:clip edge_to_edge:cleft_suture leaflet_resection:triangular leaflet_resection:quadrangular \
        leaflet_resection:anterior leaflet_resection:posterior
      ;;
  esac
}

_coapt() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  # Readline breaks words at colons; --forbid's hold some.
  local whole=$current
  if [[ $previous == : || $current == : ]]; then
    local line=${COMP_LINE:0:COMP_POINT}
    whole=${line##* }
    previous=${line% *}
    previous=${previous##* }
  fi
  local -a command=("${COMP_WORDS[0]}")
  local word names
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    names=$(_coapt_subcommands "${command[@]}")
    [[ -n $names ]] || break
    grep -qxF -e "$word" <<<"$names" && command+=("$word")
  done

  local words=''
  if [[ $whole == -* ]]; then
    words=$(_coapt_options "${command[@]}")
  else
    words=$([[ $previous != -* ]] || _coapt_values "$previous")
    [[ -n $words || $previous == -* ]] || words=$(_coapt_subcommands "${command[@]}")
    [[ -n $words || $previous == -* || ${COMP_WORDS[0]} =~ coapt-(farm|server)$ ]] || words=$(_coapt_presets "${COMP_WORDS[0]}")
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$whole")
  [[ $whole != *:* ]] || COMPREPLY=("${COMPREPLY[@]#"${whole%:*}:"}")
}

# Where nothing fits, and beside presets, files are offered.
complete -o bashdefault -o default -F _coapt coapt coapt-farm coapt-live coapt-server
