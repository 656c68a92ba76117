# matc_add_materials: placeholder while the rest is tried
