#!/bin/sh
# Holds what the architecture says of who may know whom, and that names and format are kept. Prints every breach.
set -u
cd "$(dirname "$0")/../.."
breaches=$(mktemp)
trap 'rm -f "$breaches"' EXIT

# forbid WHY PATTERN FILES...: no line of the files may match
forbid() {
    why=$1
    pattern=$2
    shift 2
    grep -nE "$pattern" "$@" /dev/null | sed "s|^|$why: |" >>"$breaches"
}

sources() {
    find "$@" \( -name '*.c' -o -name '*.h' -o -name '*.cpp' \)
}

# Each folder, the lowest first, and the folders it may include beside its own and base. A name that ends in / stands for
# all folders below it.
floors() {
    cat <<'END'
engine/base         -
engine/mechanics    -
engine/plan         mechanics
engine/space        mechanics plan
engine/route        plan space
engine/house        mechanics plan route space
engine/rules        house mechanics plan route space
engine/inquiry      house plan space
engine/cycle        mechanics
engine/beam         cycle mechanics
engine/crank        cycle mechanics
engine/study        -
engine/experiment   beam crank cycle house inquiry plan study
engine/lesson       experiment house inquiry plan space study
engine/exchange     house mechanics plan space
app/draw            -
app/paint           draw
app/plot            draw paint
app/document        draw paint
app/result          beam crank cycle document draw experiment house inquiry plan rules study
app/visual/study    cycle exchange plot study
app/visual/house    draw experiment house inquiry plan plot result route rules space study visual/study
app/visual/machine  draw
app/visual/crank    crank cycle draw mechanics plot visual/machine visual/study
app/visual/beam     beam cycle draw exchange mechanics plot visual/house visual/machine visual/study
app/laboratory            beam crank draw exchange house plan plot result visual/beam visual/crank visual/house
app/laboratory/edit       house inquiry laboratory plan result
app/laboratory/house      draw experiment house inquiry laboratory laboratory/edit plan result study visual/house
app/laboratory/machine    beam crank cycle experiment laboratory plot result study visual/study
app/laboratory/beam       beam cycle experiment laboratory laboratory/machine mechanics plot result study visual/beam visual/study
app/laboratory/crank      crank cycle draw experiment laboratory laboratory/machine mechanics plot result visual/crank
app/widgets         draw paint
app/classroom       draw lesson widgets
app/platform        draw paint plot
app/window          classroom draw laboratory laboratory/edit laboratory/house paint platform plot widgets
app/report          beam crank cycle document exchange experiment house inquiry plan plot result rules study visual/
app/teaching        classroom document draw house inquiry laboratory lesson plan visual/ window
app/options         cycle draw exchange experiment study visual/beam visual/crank visual/house
app/command         beam classroom crank cycle document draw exchange experiment house inquiry laboratory lesson mechanics options paint plan platform plot report result rules study teaching visual/ window
END
}

# Every include stands in the table, and every folder with sources, too.
check_floors() {
    floors | while read -r folder allowed; do
        pattern=base
        for name in $allowed ${folder#*/}; do
            pattern="$pattern|$name"
            case $name in */) pattern="$pattern[a-z]*" ;; esac
        done
        grep -nE '^#include "[a-z]' "$folder"/*.[ch] "$folder"/*.cpp 2>/dev/null |
            grep -vE "#include \"($pattern)/[a-z0-9_]+\.h\"" | sed "s|^|$folder may not include: |" >>"$breaches"
    done
    find engine app -mindepth 1 -type d | while read -r folder; do
        ls "$folder"/*.c >/dev/null 2>&1 || continue
        floors | grep -q "^$folder " || echo "not in the table of folders: $folder" >>"$breaches"
    done
}

# Sources that have no header of their own, and what declares their functions instead.
shared_headers() {
    cat <<'END'
app/main\.c                           - # it has no function for others
app/command/[a-z]+\.c                 app/command/command.h # each verb is one function, a row of the table of verbs
app/widgets/ui_[a-z]+\.c              app/widgets/ui.h # the files are one toolkit
END
}

# A folder can be taken in at a glance and a file be read in one go; each source has its header, and each folder of tests
# the folder that it tests.
check_sizes() {
    find engine app -type d | while read -r folder; do
        modules=$(find "$folder" -maxdepth 1 \( -name '*.c' -o -name '*.cpp' \) | wc -l)
        [ "$modules" -le 40 ] || echo "more than 40 modules: $folder has $modules" >>"$breaches"
    done
    sources engine app | while read -r source; do
        lines=$(wc -l <"$source")
        [ "$lines" -le 600 ] || echo "more than 600 lines: $source has $lines" >>"$breaches"
        case $source in *.h) continue ;; esac
        [ -f "${source%.c*}.h" ] && continue
        header=$(shared_headers | while read -r pattern shared _; do
            echo "$source" | grep -qxE "$pattern" && echo "$shared" && break
        done)
        [ "$header" = - ] || [ -f "$header" ] || echo "no header: $source" >>"$breaches"
    done
    find tests \( -name '*.c' -o -name '*.py' \) | while read -r source; do
        lines=$(wc -l <"$source")
        [ "$lines" -le 600 ] || echo "more than 600 lines: $source has $lines" >>"$breaches"
    done
    find tests/engine tests/app -type d | while read -r folder; do
        [ -d "${folder#tests/}" ] || echo "tests of a folder that does not exist: $folder" >>"$breaches"
    done
}

# A folder includes only those that stand above it in the table, so that no two folders need each other.
check_order() {
    above=" base "
    floors | while read -r folder allowed; do
        for name in ${allowed#-}; do
            case $name in */) pattern=" $name" ;; *) pattern=" $name " ;; esac
            case $above in
            *"$pattern"*) ;;
            *) echo "the table of folders: $folder may include $name, which stands below it" >>"$breaches" ;;
            esac
        done
        above="$above${folder#*/} "
    done
}

# shellcheck disable=SC2046 # file names have no spaces
{
    check_floors
    check_order
    check_sizes
    forbid 'engine draws or has a window' '#include *<(SDL|cairo|pango|GL|EGL|glib)' $(sources engine)
    forbid 'engine prints or exits' '(^|[^a-z_])(printf|puts|putchar|exit|abort) *\(' $(sources engine)
    forbid 'OpenGL outside its painter and the window that has the context' '#include "paint/(gl|shaders)\.h"' \
        $(sources engine app | grep -vE 'app/(paint/(gl|offscreen|paint_gl[a-z_]*|shaders)|platform/sdl_window)\.[ch]')
    forbid 'SDL outside the window' '#include *[<"]SDL' $(sources app | grep -vE 'app/(window|platform)/')
    forbid 'Dear ImGui outside the painter of the widgets' '#include *[<"](imgui|imstb)' $(sources engine app | grep -v app/widgets/ui.cpp)
    forbid 'widgets from inside' '#include "widgets/ui_[a-z]+\.h"' $(sources app | grep -vE 'app/widgets/')
    forbid 'Box2D outside its adaptor' 'box2d/' $(sources engine app | grep -v mechanics/broadphase.cpp)
    forbid "libm's transcendental functions outside base/real" \
        '^ *([^ */]([^/]|/[^*])*[^A-Za-z0-9_>.])?(a?(sin|cos|tan)h?|sincos|atan2|exp|exp2|expm1|exp10|log|log2|log10|log1p|pow|hypot|cbrt|fma|erfc?|[lt]gamma|c(abs|arg|exp|log|pow|sqrt|sin|cos))[fl]?\(' \
        $(sources engine app/command app/report app/document | grep -v base/real)
    forbid 'LAPACK outside what repeats, fits and makes paths free' '#include *<lapacke' $(sources engine app | grep -vE 'engine/((beam|cycle)/|route/relax|study/fit)')
    forbid 'BLAS outside the spectrum' '#include *<cblas' $(sources engine app | grep -v mechanics/spectrum.c)
    forbid 'zip files and XML outside the homes' '#include *<(zip|expat)' $(sources engine app | grep -v exchange/sh3d_home.c)
    forbid 'GEOS outside what unites, reads and writes areas' '#include *<geos' \
        $(sources engine app | grep -vE '(app/paint/tessellation|engine/(space/(solids|unite)|exchange/(jupedsim|wkt)))\.[ch]')
    forbid 'an importer outside the table of them' '#include "exchange/(sh3d|dxf|wkt|vadere|house_builder|house_finish|wall_chains)' \
        $(sources engine app | grep -v engine/exchange/)
    forbid "a test's file outside its temporary folder" '"/tmp/[^"]*XXXXXX' $(sources tests/app tests/engine tests/support)
    forbid 'memory outside memory.c' '(^|[^a-z_])(malloc|calloc|realloc) *\(' $(sources engine app | grep -v base/memory.c)
}

# An exported function's name begins with the file's name, or with the folder's and the file's; in a folder that is one module of several files
# (widgets) with the module's.
for source in $(find engine app -name '*.c' -o -name '*.cpp'); do
    module=$(basename "$source")
    module=${module%.c*}
    case $source in app/widgets/*) module=ui ;; app/main.c) continue ;; esac
    folder=$(basename "$(dirname "$source")")
    library=${source%%/*}
    object="${1:-build-test}/$library/libclearance_$library.a.p/$(echo "${source#*/}" | tr / _).o"
    nm --defined-only -g "$object" | awk '$2 == "T" { print $3 }' | while read -r name; do
        case $name in
        "$module"_* | "${module%s}"_* | "$folder"_"$module"_* | "$folder"_"${module%s}"_*) ;;
        *)
            # memory.c has the arena and what LAPACKE calls without memory, a verb's file command_VERB, and broadphase.cpp
            # the allocation of Box2D
            case $source/$name in
            engine/base/memory.c/arena_* | engine/base/memory.c/LAPACKE_xerbla | app/command/"$module".c/command_"$module") ;;
            engine/mechanics/broadphase.cpp/*b2Alloc_Default* | engine/mechanics/broadphase.cpp/*b2Free_Default*) ;;
            *) echo "exported name: $name in $source does not begin with $module" >>"$breaches" ;;
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
else
    echo "clang-format is not installed: the format is not checked" >>"$breaches"
fi

sort -u "$breaches"
count=$(sort -u "$breaches" | wc -l)
echo "layers: $count breaches"
[ "$count" -eq 0 ]
