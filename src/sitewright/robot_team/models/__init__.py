"""The robots and end effectors that come with the package, as URDF and meshes."""
