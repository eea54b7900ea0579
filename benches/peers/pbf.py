"""Holds vc-map's reading of PBF against that of XML, on files that libosmium packs.

    pip install osmium
    cargo build --release --example map
    python benches/peers/pbf.py                    # the extracts of ../shared/data/osm, and the hand-drawn town

Each file is packed with and without the authors of its elements. The map's own form has to be the same to the byte. Without osmium it
says so and ends well.
"""

import gzip
import os
import pathlib
import subprocess
import sys
import tempfile

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TARGET = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target"))
EXAMPLE = TARGET / "release" / "examples" / "map"


def pack(osmium, plain, packed, metadata):
    # The header has the bounds, by which a map is laid out.
    header = osmium.io.Reader(str(plain)).header()
    writer = osmium.SimpleWriter(osmium.io.File(str(packed), f"pbf,add_metadata={metadata}"), header=header)
    for element in osmium.FileProcessor(str(plain)):
        writer.add(element)
    writer.close()


def own_form(file, folder):
    folder.mkdir()
    subprocess.run([EXAMPLE, file, "--out", folder, "--scale", "0.1"], check=True, capture_output=True)
    return next(folder.glob("*.map.json")).read_bytes()


def same(osmium, file, folder):
    name = file.name.split(".")[0]
    plain = folder / f"{name}.osm"
    plain.write_bytes(gzip.decompress(file.read_bytes()) if file.suffix == ".gz" else file.read_bytes())
    expected, alike = own_form(plain, folder / "xml"), True
    for metadata in ["true", "false"]:
        packed = folder / metadata / f"{name}.osm.pbf"
        packed.parent.mkdir()
        pack(osmium, plain, packed, metadata)
        found = own_form(packed, folder / f"{metadata}-map")
        print(f"{name}, authors {metadata}: {packed.stat().st_size} bytes, {'the same map' if found == expected else 'ANOTHER MAP'}")
        alike &= found == expected
    return alike


def main():
    try:
        import osmium
    except ImportError:
        print("osmium is not installed: nothing was compared")
        return
    data = pathlib.Path(os.environ.get("VC_DATA", PROJECT.parent / "shared" / "data")) / "osm"
    alike = True
    for file in [*sorted(data.glob("*.osm.gz")), PROJECT / "vc-map" / "data" / "riverside.osm"]:
        with tempfile.TemporaryDirectory() as folder:
            alike &= same(osmium, file, pathlib.Path(folder))
    sys.exit(not alike)


main()
