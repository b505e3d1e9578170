"""suna_import -- `dem import`: input of other codes translated into scenes and cases of Suna.

    scene_text.py   the text of a scene or of demProperties
    report.py       what was translated, approximated, left out as harmless; what cannot be
                    translated
    __main__.py     the command

LIGGGHTS:

    liggghts_script.py, liggghts_expression.py   commands in the order of execution, variables
    liggghts_words.py                            words of a command, each read with a check
    liggghts.py, liggghts_state.py               commands change a state; runs are stages
    liggghts_head.py, liggghts_atoms.py          commands: box and laws; particles one by one
    liggghts_restart.py                          read_restart: the script that writes the file
    liggghts_fixes.py, liggghts_wall_fixes.py, liggghts_insert_fixes.py     fixes
    liggghts_contact.py                          contact models as effects
    liggghts_region.py, liggghts_mesh.py         regions; triangles and tetrahedra of files
    liggghts_clumps.py                           clumps
    liggghts_insertion.py, liggghts_packing.py   templates, distributions, packings and streams
    liggghts_particles.py, units.py              single particles, data files, dumps; units
    liggghts_scene.py                            scenes from the stages
    liggghts_scene_laws.py, liggghts_scene_walls.py, liggghts_scene_particles.py,
    liggghts_scene_time.py                       their sections

Coupled cases:

    cfdem.py, cfdem_models.py                    CFDEMcoupling
    cfdem_script.py, cfdem_walls.py              its DEM script, its walls beside patches
    cloud.py, cloud_models.py, cloud_sizes.py, cloud_injection.py     OpenFOAM's clouds
    coupled_case.py                              the case that is written
    foam_dictionary.py, foam_reader.py, mesh_patches.py      OpenFOAM's dictionaries and meshes
    mesh_surfaces.py                             distances of walls of triangles from patches

SPDX-License-Identifier: GPL-3.0-or-later
"""
