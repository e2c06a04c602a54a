#!/bin/sh
# Tells the desktop of this user where the program is, and which files it opens. Run it where the folder is to stay.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
share=${XDG_DATA_HOME:-$HOME/.local/share}
mkdir -p "$share/applications" "$share/mime/packages" "$share/icons/hicolor/512x512/apps"
sed "s|^Exec=PhonemeAnalyser|Exec=\"$here/PhonemeAnalyser\"|" "$here/phonemeanalyser.desktop" > "$share/applications/phonemeanalyser.desktop"
cp "$here/phonemeanalyser-mime.xml" "$share/mime/packages/"
cp "$here/phonemeanalyser.png" "$share/icons/hicolor/512x512/apps/"
if command -v update-mime-database > /dev/null; then update-mime-database "$share/mime"; fi
if command -v update-desktop-database > /dev/null; then update-desktop-database "$share/applications"; fi
