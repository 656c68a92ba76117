#!/bin/sh
# Links and draws matc's programs for WebGL 2 in a browser:
# run.sh MATC BUILD_FOLDER [--all] [--part=K/N] [--minutes=N]. MATC_BROWSER names a Chromium; by
# default the first installed one. Run from the project's root. Status 77: skipped.
set -u
. tests/npm.sh
matc=$1
folder=$2/browser
shift 2
browser=${MATC_BROWSER:-$(command -v chromium || command -v chromium-browser || command -v google-chrome)} ||
    skip "no Chromium is installed (./setup browser installs it), so no browser drew anything"
npm_fetch tests/browser "$folder" check.mjs matc.mjs programs.mjs values.mjs gbuffer.mjs judged.mjs pictures.mjs page.js
exec node "$folder/check.mjs" "$matc" . "$folder" "$browser" "$@"
