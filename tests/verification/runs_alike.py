# SPDX-License-Identifier: GPL-3.0-or-later
"""What two runs have written: histories, and files for ParaView, read by its library and by the project's own tools."""
import pathlib
import re
import sys

import h5py
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "src/tools"))
from hybrid_run.pictures import Picture  # noqa: E402 (needs the path above)


def series(directory):
    """Everything of run.h5 that has a time but how long it took."""
    data = {}
    with h5py.File(directory / "run.h5", "r") as file:
        file.visititems(lambda name, item: data.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
    return {name: value for name, value in data.items() if name != "steps/wall_time" and value.dtype.kind == "f"}


def largest_difference(one, other, prefix):
    """Of series of a kind - displacement, energy - over the largest value of that kind [-], and where."""
    peaks, worst, where = {}, 0., ""
    names = [name for name in one if name.startswith(prefix) and "residual" not in name and "time" not in name]
    if not names:
        sys.exit(f"error: there are no series {prefix}")
    kind = (lambda name: name.split("/")[-1]) if prefix == "monitors/" else (lambda name: prefix)
    for name in names:
        peaks[kind(name)] = max(peaks.get(kind(name), 0.), numpy.abs(one[name]).max(initial=0.))
    for name in names:
        if peaks[kind(name)] > 0.:
            difference = numpy.abs(one[name] - other[name]).max() / peaks[kind(name)]
            if difference > worst:
                worst, where = difference, name
    return worst, where


def arrays_by_vtk(file):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    grid = reader.GetOutput()
    arrays = {"points": grid.GetPoints().GetData(), "cells": grid.GetCells().GetData()}
    for data in (grid.GetPointData(), grid.GetCellData()):
        arrays.update({data.GetArrayName(k): data.GetArray(k) for k in range(data.GetNumberOfArrays())})
    return {name: vtk_to_numpy(array) for name, array in arrays.items()}


def arrays_by_tools(file):
    picture = Picture(str(file))
    return {"points": picture.points, "cells": picture.connectivity, "starts": picture.starts, **picture.fields}


def unlike(known, found, tolerances):
    """Sentences: what differs but for how many blocks arrays are compressed in, and round-off; fields are in single precision."""
    text = [re.sub(r'(format="binary">)[^<]*', r"\1", file.read_text()) for file in (known, found)]
    if text[0] != text[1]:
        yield f"{found}: not the text of the other"
    for read in (arrays_by_vtk, arrays_by_tools):
        one, other = read(known), read(found)
        if list(one) != list(other):
            yield f"{found}: other arrays"
            continue
        for name, values in one.items():
            if values.shape != other[name].shape or values.size == 0:
                yield f"{found}: {name} of another size, or of none"
                continue
            off = numpy.abs(values.astype(float) - other[name]).max()
            tolerance = tolerances.get(name, 0.)
            if not off <= tolerance:
                yield f"{found}, {name}: {off:.3g} off, more than {tolerance:.3g}"
