# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of a run: blocks.pvd, joints.pvd and continuum.pvd with their .vtu files, as the program writes them.

Other writers' files may be laid out otherwise; those are for VTK.
"""

import base64
import os
import xml.etree.ElementTree as xml
import zlib

import numpy as np

from .errors import MissingData, UserError

TYPES = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "UInt8": "u1"}
HEADER = 3 * 8  # numbers of 8 bytes: blocks, their size, that of a smaller last one; then the compressed size of each


class Picture:
    """One file.

    points: where they are now [m], n x 2. cells: of each, the numbers of its points: connectivity, cut at starts.
    fields: by name and unit, as "displacement [m]", a row for each point or cell; vectors have x and y.
    """

    def __init__(self, path):
        """@raises UserError if it cannot be read."""
        try:
            arrays = {}
            for array in xml.parse(path).getroot().iter("DataArray"):
                arrays[array.get("Name")] = values_of(array)
            self.points = arrays.pop("Points")[:, :2]
            self.connectivity, ends = arrays.pop("connectivity"), arrays.pop("offsets")
        except (OSError, KeyError, ValueError, xml.ParseError, zlib.error) as error:
            raise UserError("cannot read the picture '%s': %s" % (path, error)) from error
        arrays.pop("types", None)
        self.starts = np.concatenate([[0], ends[:-1]]).astype(int) if len(ends) else ends
        self.fields = {name: values[:, :2] if "displacement" in name or "velocity" in name else values for name, values in arrays.items()}

    @property
    def cells(self):
        return np.split(self.connectivity, self.starts[1:]) if len(self.starts) else []

    def of_cells(self, values):
        """Mean over the points of each cell of what points have."""
        sums = np.add.reduceat(values[self.connectivity], self.starts, axis=0) if len(self.starts) else values[:0]
        counts = np.diff(np.append(self.starts, len(self.connectivity)))
        return (sums.T / counts).T


def values_of(array):
    """Numbers of a DataArray: base64 of a header, then of zlib blocks, one of each process that wrote it."""
    text = "".join((array.text or "").split())
    kind, columns = np.dtype(TYPES[array.get("type")]), int(array.get("NumberOfComponents", 1))
    n_blocks = int(np.frombuffer(base64.b64decode(text[: 4 * HEADER // 3]), "<u8")[0])
    coded = -(-(HEADER + 8 * n_blocks) // 3) * 4  # base64 of the header, filled up with =
    sizes = np.frombuffer(base64.b64decode(text[:coded]), "<u8")[3:]
    blocks, ends = base64.b64decode(text[coded:]), np.cumsum(sizes).astype(int)
    values = np.frombuffer(b"".join(zlib.decompress(blocks[end - size : end]) for size, end in zip(sizes.astype(int), ends)), kind)
    return values.reshape(-1, columns) if columns > 1 else values


class Pictures:
    """A series: times [s], and pictures by number. "blocks", "joints" or "continuum"."""

    def __init__(self, directory, name):
        """@raises MissingData if the run wrote none."""
        path = os.path.join(directory, name + ".pvd")
        if not os.path.exists(path):
            raise MissingData("no %s.pvd in '%s'" % (name, directory))
        try:
            entries = [(float(entry.get("timestep")), entry.get("file")) for entry in xml.parse(path).getroot().iter("DataSet")]
        except (xml.ParseError, TypeError, ValueError) as error:
            raise UserError("cannot read '%s': %s" % (path, error)) from error
        self.times = np.array([time for time, _ in entries])
        self.files = [os.path.join(directory, file) for _, file in entries]

    def __len__(self):
        return len(self.files)

    def __getitem__(self, number):
        return Picture(self.files[number])
