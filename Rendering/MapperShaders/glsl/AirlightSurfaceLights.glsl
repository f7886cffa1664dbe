// What both shaders of a mapper know of lights.

// w 1: position; 0: direction towards a light at infinity; -1: left as VTK shades it
uniform vec4 airlightSceneLights[AIRLIGHT_SCENE_LIGHTS];
uniform int airlightSceneLightCount;
