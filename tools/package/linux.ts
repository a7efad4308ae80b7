import { chmod, cp, mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

const MIME_TYPE = 'application/vnd.scrim.project+json';

/** Type of project files for the shared MIME database of freedesktop.org. */
const MIME_INFO = `<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="${MIME_TYPE}">
    <comment>Scrim project</comment>
    <sub-class-of type="application/json"/>
    <icon name="scrim"/>
    <glob pattern="*.scrim.json" weight="80"/>
  </mime-type>
</mime-info>
`;

/** Desktop entry of freedesktop.org. `@PROGRAM@` is replaced by the final path. */
const DESKTOP_ENTRY = `[Desktop Entry]
Type=Application
Name=Scrim
GenericName=Mixed-reality editor
Comment=Wire mixed-reality layers and effects, export them as a web page
Exec="@PROGRAM@" %f
Icon=scrim
Terminal=false
StartupWMClass=Scrim
Categories=Graphics;3DGraphics;Development;
MimeType=${MIME_TYPE};
Keywords=AR;XR;WebXR;shader;GLSL;effect;
`;

const REGISTER = `#!/bin/sh
# Tells this person's desktop of Scrim: an entry in its menu, an icon, and what opens project.scrim.json. \`--undo\` takes it back.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
data=\${XDG_DATA_HOME:-$HOME/.local/share}
entry=$data/applications/scrim.desktop
info=$data/mime/packages/scrim.xml
icon=$data/icons/hicolor/512x512/apps/scrim.png
if [ "\${1:-}" = --undo ]; then
  rm -f "$entry" "$info" "$icon"
else
  mkdir -p "$(dirname "$entry")" "$(dirname "$info")" "$(dirname "$icon")"
  sed "s|@PROGRAM@|$here/scrim|" "$here/resources/desktop/scrim.desktop" > "$entry"
  cp "$here/resources/desktop/scrim.xml" "$info"
  cp "$here/resources/desktop/scrim.png" "$icon"
fi
# Desktops without these tools look for themselves when they start.
update-mime-database "$data/mime" >/dev/null 2>&1 || true
update-desktop-database "$data/applications" >/dev/null 2>&1 || true
`;

/** Adds the files of a Linux desktop to the app’s folder, with a script that installs them. */
export async function addDesktopFiles(app: string, root: string): Promise<void> {
  const folder = join(app, 'resources', 'desktop');
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, 'scrim.desktop'), DESKTOP_ENTRY);
  await writeFile(join(folder, 'scrim.xml'), MIME_INFO);
  await cp(join(root, 'app', 'electron', 'icons', 'scrim.png'), join(folder, 'scrim.png'));
  await writeFile(join(app, 'register'), REGISTER);
  await chmod(join(app, 'register'), 0o755);
}
