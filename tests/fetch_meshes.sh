#!/usr/bin/env bash
# fetch_meshes.sh DEST: strangers' meshes, for tests and for ./run. Downloads two Debian packages of
# test data (45 MB) and unpacks them, without installing: DEST/cgal/*.off|ply|stl (scans and CAD
# parts; licences in the package's sources) and DEST/assimp/FORMAT/*. Done once.
set -euo pipefail
dest=$1
[[ -e $dest/complete ]] && exit 0

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 755 "$work"
cd "$work"
download() { apt-get -q download libcgal-demo assimp-testmodels; }
# A fresh machine has no package lists yet.
refresh() {
  if [[ $(id -u) == 0 ]]; then apt-get -q update; else sudo -n apt-get -q update; fi
}
download >log 2>&1 || { refresh && download; } >>log 2>&1 || {
  echo "fetch_meshes: cannot download libcgal-demo and assimp-testmodels: $(tail -n 1 log)" >&2
  exit 1
}
for package in *.deb; do dpkg-deb -x "$package" files; done
tar xzf files/usr/share/doc/libcgal-dev/data.tar.gz data/meshes

cd - >/dev/null
mkdir -p "$dest"
rm -rf "$dest/cgal" "$dest/assimp"
cp -r "$work/data/meshes" "$dest/cgal"
cp -r "$work/files/usr/share/assimp/models" "$dest/assimp"
touch "$dest/complete"
