#!/bin/sh
# Writes extension.toml: Zed builds the grammar from a commit of a repository, which is this one.
set -eu
cd "$(dirname "$0")"
repository=$(git rev-parse --show-toplevel)
revision=$(git rev-parse HEAD)
sed -e "s|@REPOSITORY@|file://$repository|" -e "s|@REVISION@|$revision|" extension.toml.in >extension.toml
