"""Prints as JSON what VTK's own reader finds in every .vtp that DIRECTORY/run.pvd lists. Exit code 77: there is no VTK."""

import json
import pathlib
import sys
import xml.etree.ElementTree

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    sys.exit(77)


def arrays_of(fields):
    found = {}
    for k in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(k)
        found[array.GetName()] = {
            "type": array.GetDataTypeAsString(),
            "tuples": [list(array.GetTuple(n)) for n in range(array.GetNumberOfTuples())],
        }
    return found


def cells_of(cells):
    offsets, connectivity = cells.GetOffsetsArray(), cells.GetConnectivityArray()
    ends = [int(offsets.GetTuple1(n)) for n in range(offsets.GetNumberOfTuples())]
    corners = [int(connectivity.GetTuple1(n)) for n in range(connectivity.GetNumberOfTuples())]
    return [corners[a:b] for a, b in zip(ends, ends[1:])]


directory = pathlib.Path(sys.argv[1])
collection = xml.etree.ElementTree.parse(directory / "run.pvd").getroot().find("Collection")
read = []
for dataset in collection.findall("DataSet"):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(directory / dataset.get("file")))
    reader.Update()
    poly = reader.GetOutput()
    read.append(
        {
            "time": float(dataset.get("timestep")),
            "part": int(dataset.get("part")),
            "name": dataset.get("name"),
            "file": dataset.get("file"),
            "points": [list(poly.GetPoint(k)) for k in range(poly.GetNumberOfPoints())],
            "verts": cells_of(poly.GetVerts()),
            "lines": cells_of(poly.GetLines()),
            "polys": cells_of(poly.GetPolys()),
            "point_data": arrays_of(poly.GetPointData()),
            "cell_data": arrays_of(poly.GetCellData()),
        }
    )
json.dump(read, sys.stdout)
