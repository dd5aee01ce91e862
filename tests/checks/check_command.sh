#!/bin/sh
# The command `knittsim-cli check`: exit codes, several files, profiles, rules turned off.
# check_command.sh KNITTSIM_CLI PROGRAMS PROFILES
set -eu
cli=$1
programs=$2
profiles=$3
bad=0
output=$(mktemp)
trap 'rm -f "$output"' EXIT
export KNITTSIM_MACHINES=/nonexistent # not those of the user who runs this

# expect CODE ARGUMENT... : runs check, keeps what it prints
expect() {
    wanted=$1
    shift
    code=0
    "$cli" check "$@" >"$output" 2>&1 || code=$?
    if [ "$code" != "$wanted" ]; then
        echo "check $*: exit $code, expected $wanted"
        cat "$output"
        bad=1
    fi
}

# says TEXT : the last output holds it
says() {
    if ! grep -qF -- "$1" "$output"; then
        echo "expected '$1' in:"
        cat "$output"
        bad=1
    fi
}

expect 0 "$programs/sound/rows.k"
says "0 errors"
says "(machine shima-swg)"
expect 0 "$programs/broken/long-float.k" # a warning only
expect 1 "$programs/broken/same-bed.k"
says "same-bed.k:9: error KS0207:"
expect 2 "$programs/broken/unknown-operation.k"
says "unknown-operation.k:5:1: error KS0107:"
expect 2 "$programs/none.k"
says "KS0001"

# Several files: each is told, the worst one decides.
expect 1 "$programs/sound/rows.k" "$programs/broken/same-bed.k" "$programs/sound/rib.k"
says "rows.k: 0 errors"
says "same-bed.k: 1 error"
says "rib.k: 0 errors"

# A rule turned off does not count, and its reason is kept.
expect 0 "$programs/broken/same-bed.k" --off "KS0207=tried on the machine"
says "turned off: tried on the machine"
expect 0 "$programs/broken/same-bed.k" --off "same-bed=by its name" --format json
says '"off_reason": "by its name"'
expect 0 "$programs/broken/same-bed.k" --off "KS0207=kept in SARIF" --format sarif
says '"justification": "kept in SARIF"'
expect 2 "$programs/broken/same-bed.k" --off KS0207
says "KS0244"
expect 2 "$programs/broken/same-bed.k" --off "nonsense=why"
says "KS0008"

# The machine of the header, another one, one of the user.
expect 0 "$programs/sound/rows.k" --machine kniterate
says "(machine kniterate)"
says "KS0215"
expect 2 "$programs/sound/rows.k" --machine none
says "generic-e15, kniterate, shima-swg, stoll-cms"
KNITTSIM_MACHINES=$profiles
expect 0 "$programs/sound/rows.k" --machine interpreter
says "(machine interpreter)"
expect 0 --machines
says "interpreter"

# A report beside the findings changes no exit code.
report=$(mktemp -d)
expect 1 "$programs/broken/same-bed.k" --report "$report/a.html"
grep -q KS0207 "$report/a.html" || { echo "the page does not name KS0207"; bad=1; }
expect 0 "$programs/broken/same-bed.k" --off "KS0207=tried" --report "$report/a.json"
grep -q '"off_reason": "tried"' "$report/a.json" || { echo "the report does not name the reason"; bad=1; }
grep -q "\"$(sha256sum <"$programs/broken/same-bed.k" | cut -c1-64)\"" "$report/a.json" || { echo "wrong hash"; bad=1; }
expect 2 "$programs/none.k" --report "$report/none.html"
grep -q KS0001 "$report/none.html" || { echo "no report of what cannot be read"; bad=1; }
expect 2 "$programs/sound/rows.k" --report "$report/a.pdf"
says "KS0025"
expect 2 "$programs/sound/rows.k" "$programs/sound/rib.k" --report "$report/b.html"
[ ! -e "$report/b.html" ] || bad=1
rm -r "$report"

expect 0 --rules
says "KS0235"
expect 2
exit "$bad"
