#!/bin/sh
# The arrows of the house: a folder of core/ includes only folders above it in the list, core/ knows neither Qt nor
# OpenGL, ui/render knows no Qt, and the command line knows no Qt.   check_includes.sh SOURCE_DIR
set -eu
cd "$1"
order="base yarn machine lesson formats pattern fabric physics geometry simulation export"
bad=0

complain() {
    echo "$*"
    bad=1
}

above=
for folder in $order; do
    above="$above|$folder"
    [ -d "core/$folder" ] || continue
    found=$(grep -rnE '#include "core/' "core/$folder" --include=*.h --include=*.cpp |
        grep -vE "#include \"core/(${above#|})/" || true)
    [ -z "$found" ] || complain "core/$folder looks down:
$found"
done

found=$(grep -rnE '#include (<Q[A-Za-z]|<GL/|<EGL/|<epoxy/|"ui/|"app/)' core --include=*.h --include=*.cpp || true)
[ -z "$found" ] || complain "core/ includes Qt, OpenGL, ui/ or app/:
$found"

found=$(grep -rnE '#include <Q[A-Za-z]' ui/render app/cli --include=*.h --include=*.cpp || true)
[ -z "$found" ] || complain "ui/render or app/cli includes Qt:
$found"

found=$(grep -rlE 'opengl|<GL/|<EGL/|<epoxy/' ui --include=*.h --include=*.cpp | grep -v '^ui/render/' |
    grep -v '^ui/views/fabric_view/' || true)
[ -z "$found" ] || complain "OpenGL outside ui/render:
$found"

exit "$bad"
