#!/bin/sh
# Holds what the architecture says of who may know whom, and that names and format are kept. Prints every breach.
set -u
cd "$(dirname "$0")/.."
breaches=$(mktemp)
trap 'rm -f "$breaches"' EXIT

# forbid WHY PATTERN FILES...: no line of the files may match
forbid() {
    why=$1
    pattern=$2
    shift 2
    grep -nE "$pattern" "$@" /dev/null | sed "s/^/$why: /" >>"$breaches"
}

sources() {
    find "$@" \( -name '*.c' -o -name '*.h' -o -name '*.cpp' \)
}

# shellcheck disable=SC2046 # file names have no spaces
{
    forbid 'engine knows the app' '#include "(command|report|document|laboratory|draw|window)/' $(sources engine)
    forbid 'engine draws or has a window' '#include *<(SDL|cairo|pango|GL|EGL|glib)' $(sources engine)
    forbid 'engine prints or exits' '(^|[^a-z_])(printf|puts|putchar|exit|abort) *\(' $(sources engine)
    forbid 'base knows what is above it' '#include "(mechanics|house|beam|crank|study|exchange)/' $(sources engine/base)
    forbid 'mechanics knows what is above it' '#include "(house|beam|crank|study|exchange)/' $(sources engine/mechanics)
    forbid 'house knows a neighbour' '#include "(beam|crank|study|exchange)/' $(sources engine/house)
    forbid 'beam knows a neighbour' '#include "(house|crank|study|exchange)/' $(sources engine/beam)
    forbid 'study knows a laboratory' '#include "(house|beam|crank|exchange)/' $(sources engine/study)
    forbid 'draw knows a laboratory, a command or the window' '#include "(command|report|document|window|laboratory|house|beam)/' $(sources app/draw)
    forbid 'a document knows more than draw and base' '#include "(command|report|window|laboratory|house|beam|exchange|mechanics)/' $(sources app/document)
    forbid 'a laboratory knows a report, a command or the window' '#include "(command|report|document|window)/' $(sources app/laboratory)
    forbid 'a report knows a command or the window' '#include "(command|window)/' $(sources app/report)
    forbid 'the window knows a command or a report' '#include "(command|report|document)/' $(sources app/window)
    forbid 'OpenGL outside its painter and the window that has the context' '#include "draw/(gl|shaders)\.h"' \
        $(sources engine app | grep -vE 'app/(draw/(gl|offscreen|paint_gl[a-z_]*|shaders)|window/glass)\.[ch]')
    forbid 'SDL outside the window' '#include *[<"]SDL' $(sources app | grep -v app/window/)
    forbid 'Dear ImGui outside the pencil of the widgets' '#include *[<"](imgui|imstb)' $(sources engine app | grep -v app/window/ui.cpp)
    forbid 'widgets from inside' '#include "window/ui_inside\.h"' $(sources app | grep -vE 'app/window/ui(_[a-z]+)?\.(c|cpp)')
    forbid 'Box2D outside its adaptor' 'box2d/' $(sources engine app | grep -v house/broadphase.cpp)
    forbid 'LAPACK outside the beam' '#include *<lapacke' $(sources engine app | grep -v engine/beam/)
    forbid 'FFTW outside the spectrum' '#include *<fftw' $(sources engine app | grep -v mechanics/spectrum.c)
    forbid 'zip files and XML outside the homes' '#include *<(zip|expat)' $(sources engine app | grep -v exchange/sh3d_home.c)
    forbid 'GEOS outside what unites, reads and writes areas' '#include *<geos' \
        $(sources engine app | grep -vE '(app/draw/tessellation|engine/(house/solids|exchange/(jupedsim|wkt)))\.[ch]')
    forbid 'an importer outside the table of them' '#include "exchange/(sh3d|dxf|wkt|vadere|house_builder|house_finish|wall_chains)' \
        $(sources engine app | grep -v engine/exchange/)
    forbid 'memory outside memory.c' '(^|[^a-z_])(malloc|calloc|realloc) *\(' $(sources engine app | grep -v base/memory.c)
}

# An exported function's name begins with its module's, the file's name.
# The widgets are one module of several files.
for object in $(find "${1:-build-test}" -path '*clearance_*.a.p/*.c.o' -o -path '*clearance_*.a.p/*.cpp.o'); do
    module=$(basename "$object" .o)
    module=${module%.c*}
    case $object in
    *clearance_app*/window_ui_*) module=ui ;;
    *clearance_app*) module=$(echo "$module" | sed 's/^\(document\|draw\|laboratory\|report\|command\|window\)_//') ;;
    *) module=$(echo "$module" | sed 's/^\(base\|mechanics\|house\|beam\|study\|exchange\)_//') ;;
    esac
    nm --defined-only -g "$object" | awk '$2 == "T" { print $3 }' | while read -r name; do
        case $name in
        "$module"_* | "${module%s}"_*) ;;
        *)
            # memory.c has the arena, and a verb's file command_VERB
            case $module/$name in
            memory/arena_*) ;;
            cases/command_cases | check/command_check | export/command_export | import/command_import | compare/command_compare | loci/command_loci | open/command_open | run/command_run | schema/command_schema | study/command_study) ;;
            *) echo "exported name: $name in $module.c does not begin with $module" >>"$breaches" ;;
            esac
            ;;
        esac
    done
done

# Each header compiles alone.
for header in $(find engine app -name '*.h'); do
    echo "#include \"${header#*/}\"" | cc -std=gnu11 -D_GNU_SOURCE -fsyntax-only -Iengine -Iapp \
        $(pkg-config --cflags pangocairo jansson) -xc - 2>/dev/null || echo "header does not compile alone: $header" >>"$breaches"
done

if command -v clang-format >/dev/null; then
    # shellcheck disable=SC2046
    clang-format --dry-run $(sources engine app tests) 2>&1 | grep 'warning:' | sed 's/^/format: /' >>"$breaches"
fi

sort -u "$breaches"
count=$(sort -u "$breaches" | wc -l)
echo "layers: $count breaches"
[ "$count" -eq 0 ]
