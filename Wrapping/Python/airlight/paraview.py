# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A medium in ParaView's render views, for scripts without the plugin.

    import airlight.paraview
    fog = airlight.vtkParticipatingMedium()
    fog.SetVisibility(20)
    fog_pass = airlight.paraview.attach(view, fog)

The package must have been built for ParaView's VTK (see ParaView/ in the sources). State files do
not know of the medium, and neither do the other ranks of a parallel ParaView: the plugin's view
serves there.
"""

import airlight

# By the address of the renderer, which is not kept alive: the pass, the observers' tags, ParaView's
# own pass.
_ATTACHED = {}


def _key(renderer):
    return renderer.GetAddressAsString("vtkRenderer")


def _get_renderer(view):
    proxy = getattr(view, "SMProxy", view)
    renderer = getattr(proxy, "GetRenderer", lambda: None)()
    if renderer is None:
        raise TypeError(f"{view!r} is no render view: give what GetActiveView() or CreateView() "
                        "returned for one.")
    return renderer


def _check_serial():
    from vtkmodules.vtkParallelCore import vtkMultiProcessController
    controller = vtkMultiProcessController.GetGlobalController()
    if controller and controller.GetNumberOfProcesses() > 1:
        raise RuntimeError(
            f"airlight.paraview.attach() draws on one process only and there are "
            f"{controller.GetNumberOfProcesses()}: use the plugin's view \"AirlightRenderView\".")


def attach(view, medium=None):
    """Draw a render view's scene in a medium.

    view: a ParaView render view. medium: a vtkParticipatingMedium; None draws shadows alone.
    Returns the vtkAirlightPass, whose properties can be changed at any time; a view that has one
    keeps it.

    ParaView puts its own pass back whenever it picks or antialiasing is switched. So the pass is
    armed again whenever the view is about to draw; picking itself is left to ParaView. Tone mapping
    is left out. Raises TypeError where the view is none, RuntimeError on several processes.
    """
    renderer = _get_renderer(view)
    _check_serial()
    key = _key(renderer)
    if key in _ATTACHED:
        render_pass = _ATTACHED[key][0]
    else:
        render_pass = airlight.vtkAirlightPass()
        tags = (renderer.AddObserver("StartEvent", _rearm),
                renderer.AddObserver("DeleteEvent", lambda *_: _ATTACHED.pop(key, None)))
        _ATTACHED[key] = [render_pass, tags, renderer.GetPass()]
    render_pass.RemoveAllMedia()
    render_pass.SetMedium(medium)
    return render_pass


def _rearm(renderer, _event):
    entry = _ATTACHED.get(_key(renderer))
    if entry is None or renderer.GetSelector() is not None:
        return
    if renderer.GetPass() is not entry[0]:
        entry[2] = renderer.GetPass()
        renderer.SetPass(entry[0])


def detach(view):
    """Draw the view as ParaView does. A view that nothing is attached to stays as it is."""
    renderer = _get_renderer(view)
    entry = _ATTACHED.pop(_key(renderer), None)
    if entry is None:
        return
    for tag in entry[1]:
        renderer.RemoveObserver(tag)
    if renderer.GetPass() is entry[0]:
        renderer.SetPass(entry[2])
    entry[0].ReleaseGraphicsResources(renderer.GetRenderWindow())
