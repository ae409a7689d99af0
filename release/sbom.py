#!/usr/bin/env python3
"""Joins the SBOMs of the packages that are released: release/sbom.py FOLDER EPOCH BOM.json... >OUT

Without the folder in which the tool ran, and with the time of the commit. A serial number would be another one in each run, so there is
none: CycloneDX only recommends it.
"""

import datetime
import json
import sys
import urllib.parse

folder, epoch, *files = sys.argv[1:]
boms = []
for file in files:
    with open(file, encoding="utf-8") as text:
        content = text.read().replace(folder, "/sins").replace(urllib.parse.quote(folder, safe=""), "%2Fsins")
    boms.append(json.loads(content))

joined = boms[0]
joined.pop("serialNumber", None)
joined["metadata"]["timestamp"] = datetime.datetime.fromtimestamp(int(epoch), datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
own = {bom["metadata"]["component"]["bom-ref"] for bom in boms}
components, dependencies = {}, {}
for bom in boms:
    main = bom["metadata"]["component"]
    for component in [*bom.get("components", []), *([main] if bom is not joined else [])]:
        components[component["bom-ref"]] = component
    for dependency in bom.get("dependencies", []):
        dependencies.setdefault(dependency["ref"], set()).update(dependency.get("dependsOn", []))
components.pop(joined["metadata"]["component"]["bom-ref"], None)
joined["components"] = [components[ref] for ref in sorted(components)]
joined["dependencies"] = [{"ref": ref, "dependsOn": sorted(on)} for ref, on in sorted(dependencies.items())]
assert own <= set(components) | {joined["metadata"]["component"]["bom-ref"]}
json.dump(joined, sys.stdout, indent=1, ensure_ascii=False)
print()
