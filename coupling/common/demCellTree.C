/*---------------------------------------------------------------------------*\
    demCellTree.C -- octree of the cells of a mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCellTree.H"
#include "Random.H"

namespace Foam
{
    defineTypeNameAndDebug(demCellTree, 0);

    // A little larger than the mesh and without its symmetry, as in polyMesh::cellTree()
    static treeBoundBox slightlyLarger(const pointField& points)
    {
        Random random(261782);
        return treeBoundBox(points).extend(random, 1e-4);
    }
}


Foam::demCellTree::demCellTree(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, demCellTree>(mesh),
    tree_
    (
        treeDataCell(true, mesh, polyMesh::CELL_TETS),
        slightlyLarger(mesh.points()),
        8,                      // levels at most
        10,                     // cells in a leaf
        5                       // leaves of a cell, on average
    )
{}


Foam::labelList Foam::demCellTree::around(const point& x) const
{
    const treeBoundBox here(x, x);
    DynamicList<label> cells;

    // a leaf has the cells whose boxes overlap the leaf's
    for (const label celli : tree_.findIndices(x))
    {
        if (tree_.shapes().overlaps(celli, here))
        {
            cells.append(celli);
        }
    }
    return labelList(cells);
}


Foam::label Foam::demCellTree::cell(const point& x) const
{
    for (const label celli : around(x))
    {
        if (tree_.shapes().contains(celli, x))
        {
            return celli;
        }
    }
    return -1;
}


Foam::label Foam::demCellTree::nearest(const point& x) const
{
    return tree_.findNearest(x, sqr(GREAT)).index();
}
