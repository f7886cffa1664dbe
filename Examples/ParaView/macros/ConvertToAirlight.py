# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A macro of ParaView: the active render view becomes a "Render View + Airlight".

In Macros, Import new macro, this file becomes a button. Camera, background, lights and all that the
view shows stay, and so does its place in the layout. Back: Convert To in the menu of the view's
title, or its property Airlight.
"""

from paraview import servermanager, simple


def convert(view=None):
    """The new view, in the place of the view given or of the active one."""
    view = view or simple.GetActiveView()
    if view is None or not view.IsA("vtkSMRenderViewProxy"):
        raise RuntimeError("The active view is no render view: select one by a click into it.")
    if view.GetXMLName() == "AirlightRenderView":
        return view
    if not servermanager.ProxyManager().GetPrototypeProxy("views", "AirlightRenderView"):
        raise RuntimeError("The plugin AirlightParaView is not loaded: Tools, Manage Plugins.")
    new = simple.CreateView("AirlightRenderView")
    new.SMProxy.Copy(view.SMProxy, "vtkSMProxyProperty")  # all but what it shows
    new.SMProxy.UpdateVTKObjects()
    new.AdditionalLights = list(view.AdditionalLights)
    for old in list(view.Representations):
        if getattr(old, "Input", None) is None:
            continue  # a legend
        shown = simple.Show(old.Input, new)
        shown.SMProxy.Copy(old.SMProxy)
        shown.SMProxy.UpdateVTKObjects()
        if hasattr(old, "IsScalarBarVisible") and old.IsScalarBarVisible(view):
            shown.SetScalarBarVisibility(new, True)
    replace(view, new)
    simple.SetActiveView(new)
    new.StillRender()  # simple.Render() would reset a camera once
    return new


def replace(view, new):
    """Give a view the place of another one, which is deleted."""
    layout = simple.GetLayout(view)
    location = layout.GetViewLocation(view.SMProxy) if layout else -1
    simple.Delete(view)
    if location >= 0:
        if simple.GetLayout(new):
            simple.GetLayout(new).RemoveView(new.SMProxy)
        layout.AssignView(location, new.SMProxy)


if __name__ in ("__main__", "__vtkconsole__"):  # the latter in ParaView's window
    convert()
