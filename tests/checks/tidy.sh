# Sourced by tests/run.sh and .ci/run: a run of tests has a temporary folder of its own, and leaves nothing in it.

# tidy_begin: makes the folder, which is TMPDIR from then on. Tests that act as other users go through it.
tidy_begin() {
    TMPDIR=$(env -u TMPDIR mktemp -d)
    export TMPDIR
    chmod 711 "$TMPDIR"
    trap 'rm -rf "$TMPDIR"' EXIT
}

# tidy_end BUILD: prints the skipped tests of the last run in that build folder, and the files that tests have left, and
# removes them. Fails if there are any.
tidy_end() {
    tidy_status=0
    grep '"result": "SKIP"' "$1/meson-logs/testlog.json" | sed 's/.*"name": "\([^"]*\)".*/skipped: \1/' | grep . && tidy_status=1
    find "$TMPDIR" -mindepth 1 -maxdepth 1 | sed 's/^/left behind: /' | grep . && tidy_status=1
    [ $tidy_status -eq 0 ] || echo "no test may be skipped, nor leave files in the temporary folder"
    find "$TMPDIR" -mindepth 1 -delete
    return $tidy_status
}
