# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The oracle's scenes (Testing/Oracle) for VTK and Airlight, by their public functions."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkTable
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)

import airlight

PHASES = {"isotropic": "Isotropic", "rayleigh": "Rayleigh", "schlick": "Schlick",
          "henyey_greenstein": "HenyeyGreenstein", "cornette_shanks": "CornetteShanks",
          "mie_hazy": "MieHazy", "mie_murky": "MieMurky", "table": "Tabulated"}


def make_mesh(points, faces):
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    mesh.GetPoints().SetDataTypeToDouble()
    for point in points:
        mesh.GetPoints().InsertNextPoint(point)
    mesh.SetPolys(vtkCellArray())
    for face in faces:
        mesh.GetPolys().InsertNextCell(3, [int(i) for i in face])
    return mesh


def make_actor(surface):
    mesh = make_mesh(surface["points"], surface["faces"])
    # In double precision, which VTK's filters do not give.
    a, b, c = (np.asarray(surface["points"], float)[np.asarray(surface["faces"])[:, i]]
               for i in range(3))
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    mesh.GetCellData().SetNormals(numpy_to_vtk(normals, deep=True))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetDiffuseColor(surface["albedo"])
    return actor


def make_light(source):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    if source["type"] == "directional":
        airlight.vtkAirlight.SetIrradiance(light, source["irradiance"])
    else:
        airlight.vtkAirlight.SetRadiantIntensity(light, source["intensity"])
        light.SetAttenuationValues(source.get("attenuation", (0, 0, 1)))
    if source["type"] == "spot":
        light.SetConeAngle(source["cone_half_angle_deg"])
        light.SetExponent(source["exponent"])
    position = np.array(source.get("position", (0, 0, 0)), float)
    light.SetPosition(position)
    light.SetFocalPoint(position + source.get("direction", (0, 0, 1)))
    return light


def make_table(rows):
    table = vtkTable()
    for name, values in zip(("angle", "value"), np.transpose(rows)):
        column = numpy_to_vtk(np.array(values, float), deep=True)
        column.SetName(name)
        table.AddColumn(column)
    return table


def make_image(density):
    values = np.asarray(density["values"], float)
    image = vtkImageData()
    image.SetDimensions(values.shape[::-1])
    image.SetOrigin(density["origin"])
    image.SetSpacing(density["spacing"])
    image.SetDirectionMatrix(np.ravel(density["direction"]))
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return image


def set_phase(medium, phase):
    medium.SetPhaseTolerance(1e-6)  # the oracle knows the function exactly
    if phase["type"] == "draine":
        function = airlight.vtkDrainePhaseFunction()
        function.SetAnisotropy(phase["g"])
        function.SetAlpha(phase["alpha"])
        medium.SetPhaseFunction(function)
        return
    if phase["type"] == "table":
        medium.SetPhaseTable(make_table(phase["table"]))
    getattr(medium, "SetPhaseFunctionTo" + PHASES[phase["type"]])()
    if "g" in phase:
        medium.SetAnisotropy(phase["g"])


def set_region(medium, region):
    if region["type"] == "box":
        medium.SetBounds(np.transpose([region["min"], region["max"]]).ravel())
        medium.SetRegionToBox()
    elif region["type"] == "sphere":
        medium.SetCenter(region["center"])
        medium.SetRadius(region["radius"])
        medium.SetRegionToSphere()
    elif region["type"] == "cylinder":
        medium.SetCenter(region["center"])
        medium.SetAxis(region["axis"])
        medium.SetRadius(region["radius"])
        medium.SetHeight(region["height"])
        medium.SetRegionToCylinder()
    elif region["type"] == "mesh":
        medium.SetSurface(make_mesh(region["points"], region["faces"]))
        medium.SetRegionToSurface()


def set_density(medium, density):
    if density["type"] == "exponential_height":
        medium.SetScaleHeight(density["scale"])
        medium.SetReferenceHeight(density["reference"])
        medium.SetUp(density["up"])
        medium.SetDensityToExponentialHeight()
    elif density["type"] == "image":
        medium.SetDensityImage(make_image(density))
        medium.SetDensityToImage()


def make_medium(description):
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(description["sigma_s"])
    medium.SetAbsorption(description["sigma_a"])
    medium.SetAmbientRadiance(description.get("ambient", (0, 0, 0)))
    set_phase(medium, description.get("phase", {"type": "isotropic"}))
    set_region(medium, description.get("region", {"type": "everywhere"}))
    set_density(medium, description.get("density", {"type": "uniform"}))
    return medium


def set_camera(camera, description):
    camera.SetPosition(description["position"])
    camera.SetFocalPoint(description["focal_point"])
    camera.SetViewUp(description["view_up"])
    if "parallel_scale" in description:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(description["parallel_scale"])
    else:
        camera.SetViewAngle(description["view_angle_deg"])
    camera.SetClippingRange(0.1, 200)


class LibraryScene:
    """A scene as the pass draws it and as the reference computes it."""

    def __init__(self, scene, size):
        self.size = size
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.media = [make_medium(medium) for medium in scene["media"]]
        for surface in scene["surfaces"]:
            self.renderer.AddActor(make_actor(surface))
        self.lights = [make_light(source) for source in scene["lights"]]
        self.scatters = [source.get("scatters", True) for source in scene["lights"]]
        for light in self.lights:
            self.renderer.AddLight(light)
        self.camera = self.renderer.GetActiveCamera()
        set_camera(self.camera, scene["camera"])

    def phase_error(self):
        return max(medium.GetPhaseErrorBound() for medium in self.media)

    def add_to(self, target):
        for medium in self.media:
            target.AddMedium(medium)
        for light, scatters in zip(self.lights, self.scatters):
            target.SetLightScatters(light, scatters)

    def draw(self, names):
        """The pass's buffers by name, [pixels, channels]."""
        render_pass = airlight.vtkAirlightPass()
        self.add_to(render_pass)
        render_pass.RecordBuffersOn()
        self.renderer.SetPass(render_pass)
        window = vtkRenderWindow()
        window.OffScreenRenderingOn()
        window.SetMultiSamples(0)
        window.SetSize(self.size)
        window.AddRenderer(self.renderer)
        window.Render()
        return {name: pixels(render_pass.GetBuffer(name).GetPointData().GetScalars())
                for name in names}

    def compute(self, names):
        """The same by vtkAirlightReference."""
        reference = airlight.vtkAirlightReference()
        reference.SetRenderer(self.renderer)
        self.add_to(reference)
        reference.SetSize(self.size)
        reference.Update()
        data = reference.GetOutput().GetPointData()
        return {name: pixels(data.GetArray(name)) for name in names}


def pixels(array):
    values = vtk_to_numpy(array).astype(float)
    return values.reshape(len(values), -1)
