/*---------------------------------------------------------------------------*\
    testTransfer -- what demTransfer claims, on the mesh of the case.

    Prints "ok - claim" or "not ok - claim", with what was measured. Particles
    are made by hand and belong to ranks that have nothing to do with the mesh.
    Options tell what kind of mesh it is: -planar faces, -orthogonal, -uniform,
    -periodic in all directions. In parallel the results are compared with
    those that a serial run left in the case's file `serial`.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "fvMesh.H"
#include "volFields.H"
#include "labelIOList.H"
#include "IFstream.H"
#include "OFstream.H"
#include "demTransfer.H"
#include "grains.H"
#include <ctime>

using namespace Foam;

static const scalar diameter = 1e-3;

static void claim(const bool holds, const string& what, const scalar measured)
{
    Info<< (holds ? "ok - " : "not ok - ") << what.c_str() << " " << measured << endl;
}


static dictionary kernel(const word& name, const word& base, const scalar width)
{
    dictionary d;
    d.add("kernel", name);
    d.add("base", base);
    d.add("width", width);
    return d;
}


//- Anywhere in the box
static pointField anywhere(const boundBox& box, const label n, const uint64_t seed)
{
    pointField all(n);
    forAll(all, k)
    {
        all[k] = box.min() + cmptMultiply(chances(seed + k), box.span());
    }
    return all;
}


//- Faces, edges and points of the mesh: where things change; walls, corners and
//  faces between ranks included. The same list on all ranks.
static pointField seams(const fvMesh& mesh)
{
    List<pointField> all(Pstream::nProcs());
    DynamicList<point> mine;
    const label stride = 1 + mesh.nFaces()/300;

    forAll(mesh.faces(), facei)
    {
        const bool between = facei >= mesh.nInternalFaces();
        if (facei % stride == 0 || (between && facei % 7 == 0))
        {
            const face& f = mesh.faces()[facei];
            const point& p = mesh.points()[f[0]];
            mine.append(mesh.faceCentres()[facei]);
            mine.append(0.5*(p + mesh.points()[f[1]]));
            mine.append(0.3*p + 0.7*mesh.faceCentres()[facei]);
            mine.append(p);
        }
    }
    for (label celli = 0; celli < mesh.nCells(); celli += 1 + mesh.nCells()/50)
    {
        mine.append(mesh.cellCentres()[celli]);
    }
    all[Pstream::myProcNo()] = mine;
    Pstream::gatherList(all);
    demBroadcast(all);
    return ListListOps::combine<pointField>(all, accessOp<pointField>());
}


static scalar total(const fvMesh& mesh, const scalarField& density)
{
    return gSum(scalarField(density*mesh.V().field()));
}


//- Between 0 and 1, another number in each cell
static scalarField noise(const fvMesh& mesh, const uint64_t seed)
{
    scalarField f(mesh.nCells());
    forAll(f, celli)
    {
        f[celli] = chance((seed*Pstream::nProcs() + Pstream::myProcNo())*1000000 + celli);
    }
    return f;
}


// * * * * * * * * * * * * * * * the claims  * * * * * * * * * * * * * * * * //

//- Totals, signs and the adjoint, for one kernel
static void testKernel
(
    const fvMesh& mesh,
    const string& name,
    const dictionary& coupling,
    const pointField& all
)
{
    demTransfer transfer(mesh, coupling);
    transfer.setDiameter(diameter);
    grains g(all);
    transfer.locate(g.view, g.place.data());

    const scalarField a(g.amounts());
    const vectorField b(g.pushes());
    scalarField A;
    vectorField B;
    transfer.deposit(a, A);
    transfer.deposit(b, B);

    scalar off = mag(total(mesh, A)/gSum(a) - 1);
    for (direction c = 0; c < 3; ++c)
    {
        off = max(off, mag(total(mesh, B.component(c)) - gSum(b.component(c)))/gSum(mag(b)));
    }
    claim(off <= 1e-12, name + ": the total is kept, relative", off);
    claim(gMin(A) >= 0, name + ": no weight is negative, least density", gMin(A));

    const scalarField f(noise(mesh, 0) - 0.5);
    const vectorField v(vector(1, 2, -3)*f + vector(-2, 3, 1)*(noise(mesh, 1) - 0.5));
    const scalarField fi(transfer.sample(f));
    const vectorField vi(transfer.sample(v));
    const scalar adjoint =
        mag(gSum(a*fi) - total(mesh, A*f))/gSum(a*mag(fi))
      + mag(gSum(b & vi) - total(mesh, B & v))/gSum(mag(b & vi));
    claim(adjoint <= 1e-12, name + ": sampling is the adjoint of depositing, relative", adjoint);
    claim
    (
        gMax(fi) <= gMax(f) && gMin(fi) >= gMin(f),
        name + ": samples stay within the field's extremes, largest", gMax(fi)
    );

    const scalarField one(transfer.sample(scalarField(mesh.nCells(), 1.0)));
    const scalar uneven = gMax(mag(one - 1.0));
    claim(uneven <= 1e-13, name + ": a uniform field is sampled exactly, error", uneven);
}


//- A linear field is sampled exactly in the middle of the box: farther from the
//  walls than the weights reach, and the smoother in its one or two steps
static void testLinear
(
    const fvMesh& mesh,
    const string& name,
    const dictionary& coupling
)
{
    boundBox box(mesh.bounds());
    const vector room(0.4*box.span());
    box.min() += room;
    box.max() -= room;

    demTransfer transfer(mesh, coupling);
    transfer.setDiameter(diameter);
    const pointField all(anywhere(box, 2000, 5000));
    grains g(all);
    transfer.locate(g.view, g.place.data());

    const vector slope(1, -2, 0.5);
    const scalarField f(transfer.sample(scalarField(mesh.cellCentres() & slope)));
    scalar off = 0;
    forAll(f, i)
    {
        const vector x(all[Pstream::myProcNo() + i*Pstream::nProcs()]);
        off = max(off, mag(f[i] - (x & slope)));
    }
    reduce(off, maxOp<scalar>());
    off /= mag(slope)*mag(mesh.bounds().span());
    claim(off <= 1e-12, name + ": a linear field is sampled exactly, error over its range", off);
}


//- Weights change in proportion to the way a particle goes, on and across faces,
//  edges, points, walls and ranks
static void testContinuity(const fvMesh& mesh)
{
    demTransfer transfer(mesh, kernel("linear", "linear", 0));
    const pointField at(seams(mesh));
    const scalar h = std::cbrt(gMin(mesh.V().field()));

    const scalar ways[2] = {1e-9*diameter, 1e-3*diameter};
    scalar change[2] = {0, 0};

    for (label k = 0; k < 2; ++k)
    {
        pointField from(at), to(at);
        forAll(at, i)
        {
            const vector n(normalised(chances(9000 + i) - 0.5*vector::one));
            from[i] -= 0.5*ways[k]*n;
            to[i] += 0.5*ways[k]*n;
        }
        List<scalarField> before;
        for (const pointField& end : {from, to})
        {
            grains g(end);
            transfer.locate(g.view, g.place.data());
            for (label round = 0; round < 8; ++round)
            {
                const scalarField f(noise(mesh, round));
                if (before.size() <= round)
                {
                    before.append(scalarField(transfer.sample(f)));
                }
                else
                {
                    change[k] = max
                    (
                        change[k],
                        gMax(mag(scalarField(transfer.sample(f) - before[round])))
                    );
                }
            }
        }
    }

    claim(change[0] < 1e-6, "moving by 1e-9 d across faces and edges changes weights by", change[0]);
    claim
    (
        change[1] < 50*ways[1]/h,
        "moving by 1e-3 d changes weights in proportion, over way and cell size",
        change[1]*h/ways[1]
    );
}


//- A point source widens by b^2/2 in each direction and makes no new extreme
static void testSmoother(const fvMesh& mesh, const scalar limit)
{
    demTransfer sharp(mesh, kernel("linear", "linear", 0));
    // narrow enough not to reach the walls in the uniform box
    const scalar width = 2;
    demTransfer wide(mesh, kernel("diffusion", "linear", width));
    wide.setDiameter(diameter);

    const point x(mesh.bounds().midpoint() + vector(3e-5, 7e-5, -4e-5));
    const scalar a = Pstream::master() ? 1 : 0;
    grains g(pointField(1, x));
    sharp.locate(g.view, g.place.data());
    wide.locate(g.view, g.place.data());

    scalarField before, after;
    sharp.deposit(scalarField(label(g.view.n), a), before);
    wide.deposit(scalarField(label(g.view.n), a), after);

    claim
    (
        gMin(after) >= 0 && gMax(after) <= gMax(before),
        "smoothing makes no new extreme, peak over peak before", gMax(after)/gMax(before)
    );
    for (direction c = 0; c < 3; ++c)
    {
        const scalarField xc(mesh.cellCentres().component(c));
        const scalar grown =
            total(mesh, sqr(xc)*after) - sqr(total(mesh, xc*after))
          - total(mesh, sqr(xc)*before) + sqr(total(mesh, xc*before));
        const scalar b2 = sqr(width*diameter);
        claim
        (
            mag(grown/(0.5*b2) - 1) <= limit,
            string("a point source's variance in ") + "xyz"[c] + " grows by b^2/2, times",
            grown/(0.5*b2)
        );
    }
}


//- The walk from cell to cell ends where the search tree says
static void testWalk(const fvMesh& mesh, const bool planar)
{
    const demLocator locator(mesh);
    const pointField all(anywhere(mesh.bounds(), 100000, 30000));
    label differ = 0, apart = 0, lost = 0;
    label last = 0;

    for (const point& x : all)
    {
        // from the last point's cell: half way through the mesh
        demLocator::traveller t{x, last, 0};
        demSpot spot;
        const label celli = mesh.findCell(x);

        if (locator.walk(t, spot) != demLocator::INSIDE)
        {
            ++lost;
            continue;
        }
        last = t.cell;
        if (celli != t.cell)
        {
            ++differ;
            apart += !mesh.cellCells()[t.cell].found(celli);
        }
    }
    claim(lost == 0, "100000 walks end inside, lost:", lost);
    if (planar)
    {
        claim(differ == 0, "100000 walks end in the cell that findCell names, others:", differ);
    }
    else
    {
        // a warped face is cut here from its centre, there along a diagonal:
        // between the two cuts both answers are right
        claim
        (
            apart == 0 && differ < 5000,
            "100000 walks end in the cell that findCell names or, behind a warped face, beside it, beside:",
            differ
        );
    }
}


//- Places that are out of date, and positions one period away, change nothing
static void testPlaces(const fvMesh& mesh, const bool periodic)
{
    demTransfer transfer(mesh, kernel("linear", "linear", 0));
    pointField all(anywhere(mesh.bounds(), 3000, 60000));
    const scalarField f(sin(300*mesh.cellCentres().component(0)));

    grains g(all);
    transfer.locate(g.view, g.place.data());
    const scalarField fresh(transfer.sample(f));

    // any rank, any cell, some of which do not exist
    for (size_t i = 0; i < g.place.size()/2; ++i)
    {
        g.place[2*i] = std::floor(chance(70000 + i)*(Pstream::nProcs() + 1));
        g.place[2*i + 1] = std::floor(chance(80000 + i)*1.2*mesh.nCells());
    }
    transfer.locate(g.view, g.place.data());
    scalar off = gMax(mag(scalarField(transfer.sample(f) - fresh)));
    claim(off <= 1e-8, "places out of date are found again, samples differ by", off);

    if (periodic)
    {
        forAll(all, k)
        {
            const vector side(chances(90000 + k));
            for (direction c = 0; c < 3; ++c)
            {
                all[k][c] += mesh.bounds().span()[c]*(side[c] < 0.3 ? -1 : side[c] > 0.7 ? 1 : 0);
            }
        }
        grains away(all);
        transfer.locate(away.view, away.place.data());
        off = gMax(mag(scalarField(transfer.sample(f) - fresh)));
        claim(off <= 1e-8, "a period away is the same place, samples differ by", off);
    }
}


//- Cell values of all ranks in the order of the undivided mesh, on the master
static scalarField whole(const fvMesh& mesh, const scalarField& mine)
{
    if (!Pstream::parRun())
    {
        return mine;
    }
    const labelIOList address
    (
        IOobject
        (
            "cellProcAddressing", mesh.facesInstance(), polyMesh::meshSubDir, mesh,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    List<scalarField> values(Pstream::nProcs());
    List<labelList> cells(Pstream::nProcs());
    values[Pstream::myProcNo()] = mine;
    cells[Pstream::myProcNo()] = address;
    Pstream::gatherList(values);
    Pstream::gatherList(cells);

    scalarField all(returnReduce(mesh.nCells(), sumOp<label>()));
    if (Pstream::master())
    {
        forAll(cells, rank)
        {
            UIndirectList<scalar>(all, cells[rank]) = values[rank];
        }
    }
    return all;
}


//- Densities and samples are those of a serial run
static void testSerial(const fvMesh& mesh, const fileName& file)
{
    demTransfer transfer(mesh, kernel("diffusion", "linear", 3));
    transfer.setDiameter(diameter);
    grains g(anywhere(mesh.bounds(), 5000, 40000));
    transfer.locate(g.view, g.place.data());

    scalarField density;
    transfer.deposit(g.amounts(), density);
    density = whole(mesh, density);

    List<scalarField> samples(Pstream::nProcs());
    samples[Pstream::myProcNo()] =
        transfer.sample(scalarField(sin(300*(mesh.cellCentres() & vector(1, 2, 3)))));
    Pstream::gatherList(samples);

    if (!Pstream::parRun())
    {
        OFstream to(file);
        to.precision(17);
        to << density << samples[0];
    }
    else if (Pstream::master())
    {
        IFstream from(file);
        const scalarField density1(from), samples1(from);
        scalar off = 0;
        forAll(samples1, k)
        {
            off = max(off, mag(samples[k % Pstream::nProcs()][k/Pstream::nProcs()] - samples1[k]));
        }
        const scalar offDensity = max(mag(density - density1))/max(density1);
        claim(offDensity <= 1e-12, "densities are those of a serial run, relative", offDensity);
        claim(off <= 1e-12, "samples are those of a serial run", off);
    }
}


//- Time for one particle, for the record
static void timing(const fvMesh& mesh)
{
    demTransfer transfer(mesh, kernel("linear", "linear", 0));
    const label n = 200000;
    grains g(anywhere(mesh.bounds(), n, 100000));
    transfer.locate(g.view, g.place.data());

    const scalarField a(g.amounts());
    scalarField density;
    const std::clock_t start = std::clock();
    transfer.locate(g.view, g.place.data());
    const std::clock_t located = std::clock();
    transfer.deposit(a, density);
    const std::clock_t deposited = std::clock();
    transfer.sample(density);
    const std::clock_t sampled = std::clock();
    const scalar micro = 1e6/CLOCKS_PER_SEC/n;

    Info<< "# microseconds per particle: locate " << micro*(located - start)
        << ", deposit " << micro*(deposited - located)
        << ", sample " << micro*(sampled - deposited) << endl;
}


int main(int argc, char *argv[])
{
    argList::addBoolOption("planar", "all faces are planar");
    argList::addBoolOption("orthogonal", "lines between cell centres are normal to faces");
    argList::addBoolOption("uniform", "all cells are the same box");
    argList::addBoolOption("periodic", "cyclic in all three directions");
    argList::addBoolOption("outside", "only: put a particle outside the mesh, which must end the run");
    const argList args(argc, argv);
    Info.precision(3);
    Time runTime(Time::controlDictName, args);
    const fvMesh mesh
    (
        IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ)
    );
    const bool planar = args.found("planar");
    const bool orthogonal = args.found("orthogonal");
    const bool uniform = args.found("uniform");
    const bool periodic = args.found("periodic");

    if (args.found("outside"))
    {
        demTransfer transfer(mesh, dictionary());
        pointField all(anywhere(mesh.bounds(), 100, 0));
        all[37] = mesh.bounds().max() + 0.1*mesh.bounds().span();
        grains g(all);
        transfer.locate(g.view, g.place.data());
        return 0;
    }

    pointField all(anywhere(mesh.bounds(), 2000, 0));
    all.append(seams(mesh));

    testKernel(mesh, "particleCentre", kernel("particleCentre", "linear", 0), all);
    testKernel(mesh, "linear", kernel("linear", "linear", 0), all);
    testKernel(mesh, "diffusion 3 d", kernel("diffusion", "linear", 3), all);
    testKernel(mesh, "diffusion 12 d, wider than cells", kernel("diffusion", "linear", 12), all);
    testKernel(mesh, "diffusion from centres", kernel("diffusion", "particleCentre", 3), all);

    testLinear(mesh, "linear", kernel("linear", "linear", 0));
    if (orthogonal)
    {
        testLinear(mesh, "diffusion d/2", kernel("diffusion", "linear", 0.5));
    }
    testContinuity(mesh);
    testSmoother(mesh, uniform ? 1e-10 : orthogonal ? 0.1 : 0.2);
    testPlaces(mesh, periodic);
    if (!Pstream::parRun())
    {
        testWalk(mesh, planar);
    }
    testSerial(mesh, args.globalPath()/"serial");
    timing(mesh);
    Info<< "End of claims" << endl;
    return 0;
}


// ************************************************************************* //
