/*---------------------------------------------------------------------------*\
    demMeshCheck.C -- refuses meshes in which a point lies in several cells.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demMeshCheck.H"
#include "demPassable.H"
#include "demCellTree.H"
#include "bitSet.H"

namespace Foam
{

static const label sampleSize = 20000;


static void refuseOverset(const fvMesh& mesh)
{
    const word& type = static_cast<const polyMesh&>(mesh).type();
    word by(type.find("Overset") == string::npos ? word::null : type);

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.type() == "overset")
        {
            by = patch.name();
        }
    }
    if (!by.empty())
    {
        FatalErrorInFunction
            << "The mesh is overset (" << by << "): a point may lie in several of its cells, and"
            << " some of them are not solved, so that particles would feel no fluid there. Make"
            << " one mesh; parts of it may slide along each other (cyclicAMI), or move"
            << exit(FatalError);
    }
}


// Cells of this rank for the test of centres
static labelList sample(const fvMesh& mesh)
{
    const label all = returnReduce(mesh.nCells(), sumOp<label>());
    const label stride = max(label(1), all/sampleSize);
    bitSet slides(mesh.nCells());
    DynamicList<label> cells;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (demPassable::slides(patch))
        {
            slides.set(patch.faceCells());
        }
    }
    for (label celli = 0; celli < mesh.nCells(); celli += stride)
    {
        if (!slides.test(celli))
        {
            cells.append(celli);
        }
    }
    return labelList(cells);
}


// Is the point behind all faces of the cell? In a concave cell only some points are.
static bool isInside(const fvMesh& mesh, const point& x, const label celli)
{
    return mesh.pointInCell(x, celli, polyMesh::FACE_PLANES);
}


// Number of points that lie in cells of this rank, other than their own; `first`: one of them
static label overlaps
(
    const fvMesh& mesh,
    const UList<point>& points,
    const UList<label>& own,
    point& first
)
{
    const demCellTree& tree = demCellTree::New(mesh);
    label n = 0;

    forAll(points, k)
    {
        for (const label celli : tree.around(points[k]))
        {
            if ((own.empty() || celli != own[k]) && isInside(mesh, points[k], celli))
            {
                first = points[k];
                n++;
                break;
            }
        }
    }
    return n;
}


static void refuseOverlap(const fvMesh& mesh)
{
    const labelList own(sample(mesh));
    const List<pointField> points(demGather(pointField(mesh.cellCentres(), own)));
    point first(Zero);
    label n = 0;
    label all = 0;

    forAll(points, rank)
    {
        const bool here = rank == Pstream::myProcNo();

        all += points[rank].size();
        if (mesh.nCells() > 0)
        {
            n += overlaps(mesh, points[rank], here ? own : labelList(), first);
        }
    }

    // The point of the first rank that found any
    label rank = n > 0 ? Pstream::myProcNo() : Pstream::nProcs();
    reduce(rank, minOp<label>());
    if (rank != Pstream::myProcNo())
    {
        first = Zero;
    }
    reduce(first, sumOp<point>());
    reduce(n, sumOp<label>());
    if (n > 0)
    {
        FatalErrorInFunction
            << "Parts of the mesh overlap: the centres of " << n << " of " << all
            << " cells lie in other cells, too, one of them at " << first << " m, and a"
            << " particle there has no cell of its own. Make one mesh without overlap; parts of"
            << " it may slide along each other (cyclicAMI)" << exit(FatalError);
    }
}

} // End namespace Foam


void Foam::demMeshCheck::refuseTopologyChange()
{
    FatalErrorInFunction
        << "The mesh changes its topology, but the particles keep the cells and walls of the"
        << " mesh at the start: it may move, but not be refined or cut anew; take another"
        << " dynamicFvMesh in constant/dynamicMeshDict, or leave the particles out"
        << exit(FatalError);
}


void Foam::demMeshCheck::check(const fvMesh& mesh)
{
    refuseOverset(mesh);
    refuseOverlap(mesh);
}
