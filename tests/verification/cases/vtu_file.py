# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a .vtu picture of a run (arrays of one zlib block each) without VTK."""

import base64
import pathlib
import xml.etree.ElementTree as tree
import zlib

import numpy as np

TYPES = {"Float64": np.float64, "Float32": np.float32, "Int32": np.int32, "UInt8": np.uint8}


class Picture:
    """points (n x 3) [m]; cells: list of index arrays; cell and point fields by their names."""

    def __init__(self, file):
        piece = tree.parse(file).getroot().find("UnstructuredGrid/Piece")
        self.points = _array(piece.find("Points/DataArray"))
        cells = {a.get("Name"): _array(a) for a in piece.find("Cells")}
        self.cells = np.split(cells["connectivity"], cells["offsets"][:-1])
        self.cell_fields = {a.get("Name"): _array(a) for a in piece.find("CellData")}
        self.point_fields = {a.get("Name"): _array(a) for a in piece.find("PointData")}

    def initial(self):
        """Points before they moved, n x 2 [m]."""
        return self.points[:, :2] - self.point_fields["displacement [m]"][:, :2]

    def centroids(self):
        """Mean of each cell's points, n x 2: the centroid of a triangle."""
        return np.array([self.points[c, :2].mean(axis=0) for c in self.cells])


def _array(element):
    width = int(element.get("NumberOfComponents") or 1)
    header, text = 44, element.text.strip()  # base64 of four numbers: blocks, their size, that of the last, compressed
    values = np.frombuffer(zlib.decompress(base64.b64decode(text[header:])) if len(text) > header else b"", TYPES[element.get("type")])
    return values.reshape(-1, width) if width > 1 else values


def picture_files(directory, series):
    """Time [s] and file of each picture of directory/series.pvd."""
    root = tree.parse(pathlib.Path(directory) / (series + ".pvd")).getroot()
    return [(float(e.get("timestep")), pathlib.Path(directory) / e.get("file")) for e in root.iter("DataSet")]


def picture_at(directory, series, time):
    """The picture of directory/series.pvd nearest to a time [s], and its own time."""
    found = min(picture_files(directory, series), key=lambda e: abs(e[0] - time))
    return Picture(found[1]), found[0]


def pictures(directory, series):
    """Time [s] and picture, for each picture of directory/series.pvd."""
    for time, file in picture_files(directory, series):
        yield time, Picture(file)
