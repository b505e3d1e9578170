/*---------------------------------------------------------------------------*\
    testTransfer -- tests of demTransfer on the mesh of the case; test.py says what
    they prove.

    Prints "ok - claim" or "not ok - claim", with the measured value. Particles are
    made by hand and belong to ranks independent of the mesh. Options give the
    properties of the mesh: -planar faces, -orthogonal, -uniform, -periodic in all
    directions, -thin: one cell and periodic in z, -corner: a quarter is cut away.
    A parallel run compares with the file `serial` that a serial run left in the case.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "Time.H"
#include "testWeights.H"
#include "testBoundary.H"
#include "testPlaces.H"
#include "testShapes.H"
#include "testRings.H"
#include "testWedge.H"
#include "demParticles.H"
#include "demSelfCheck.H"
#include <ctime>

using namespace Foam;


//- Time for one particle, for the record
static void timing(const fvMesh& mesh, const kind& is)
{
    for (const word name : {"linear", "divided", "diffusion"})
    {
        demTransfer transfer(mesh, kernel(name, "linear", 3));
        const label n = name == "divided" ? 300 : 20000;
        transfer.setDiameter(diameter);
        grains g(anywhere(mesh.bounds(), n, 100000, is.corner));
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
        const scalar micro = 1e6/CLOCKS_PER_SEC/double(g.view.n);

        Info<< "# " << name << ", microseconds per particle: locate " << brief(micro*(located - start)).c_str()
            << ", deposit " << brief(micro*(deposited - located)).c_str()
            << ", sample " << brief(micro*(sampled - deposited)).c_str() << endl;
    }
}


// Does this self-check end the run at this error?
static bool ends(void (*check)(const scalar), const scalar error)
{
    try
    {
        check(error);
    }
    catch (const demFailure& failure)
    {
        return std::string(failure.what()).find("above the limit of 1e-06") != std::string::npos;
    }
    return false;
}


static void testLimits()
{
    const scalar none = std::numeric_limits<scalar>::quiet_NaN();

    for (void (*check)(const scalar) : {demSelfCheck::momentum, demSelfCheck::heat, demSelfCheck::volume})
    {
        claim
        (
            !ends(check, 0) && !ends(check, 9e-7) && ends(check, 2e-6) && ends(check, none),
            "a balance that does not close ends the run above", 1e-6
        );
    }
}


//- The weights of all kernels
static void testKernels(const fvMesh& mesh, const kind& is, const pointField& all)
{
    // long tests get a sixth of the particles
    pointField few((all.size() + 5)/6);
    forAll(few, k)
    {
        few[k] = all[6*k];
    }
    pointField fewest((few.size() + 2)/3);
    forAll(fewest, k)
    {
        fewest[k] = few[3*k];
    }
    testKernel(mesh, "particleCentre", kernel("particleCentre", "linear", 0), all);
    testKernel(mesh, "linear", kernel("linear", "linear", 0), all);
    testKernel(mesh, "divided", kernel("divided", "linear", 0), few);
    testKernel(mesh, "divided, spheres of 5 mm", kernel("divided", "linear", 0), few, 5e-3);
    testKernel(mesh, "gaussian 3 d", kernel("gaussian", "linear", 3), few);
    testKernel(mesh, "diffusion 3 d", kernel("diffusion", "linear", 3), all);
    testKernel(mesh, "diffusion 6 d, three cells wide", kernel("diffusion", "linear", 6), all);
    testKernel(mesh, "diffusion from centres", kernel("diffusion", "particleCentre", 3), all);
    testKernel(mesh, "diffusion from divided", kernel("diffusion", "divided", 3), few);
    testContinuity(mesh, "linear", kernel("linear", "linear", 0), seams(mesh));
    testContinuity(mesh, "divided", kernel("divided", "linear", 0), few);
    testContinuity(mesh, "gaussian 3 d", kernel("gaussian", "linear", 3), fewest);
    testEven(mesh, is.planar);
    testBall(mesh);
    testRelief(mesh, kernel("linear", "linear", 0), all, 0.1);

    if (!is.corner)
    {
        testLinear(mesh, "linear", kernel("linear", "linear", 0), is.thin);
        if (is.orthogonal)
        {
            testLinear(mesh, "diffusion d", kernel("diffusion", "linear", 1), is.thin, true);
        }
        testSmoother(mesh);
    }
    if (is.uniform && is.periodic)
    {
        testShortWaves(mesh);
    }
}


int main(int argc, char *argv[])
{
    argList::addBoolOption("planar", "all faces are planar");
    argList::addBoolOption("orthogonal", "lines between cell centres are normal to faces");
    argList::addBoolOption("uniform", "all cells are the same box");
    argList::addBoolOption("periodic", "cyclic in all three directions");
    argList::addBoolOption("thin", "one cell in z and cyclic there");
    argList::addBoolOption("corner", "nothing beyond the middle in x and y");
    argList::addBoolOption("widths", "only: the widths of kernels");
    argList::addBoolOption("hard", "only: totals, on cells of extreme size");
    argList::addBoolOption("wedge", "only: a wedge about z");
    argList::addBoolOption("rings", "only: two rings with a sliding interface");
    argList::addBoolOption("own", "only: kernel box of docs/kernels.md, on cubes of 2 mm");
    argList::addBoolOption("boundary", "only: the nearest faces of the boundary");
    argList::addBoolOption("outside", "only: put a particle outside the mesh");
    argList::addBoolOption("same", "only: what a serial run has not shown, and that results agree with it");
    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    const fvMesh mesh
    (
        IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ)
    );
    const kind is =
    {
        args.found("planar"), args.found("orthogonal"), args.found("uniform"),
        args.found("periodic"), args.found("thin"), args.found("corner")
    };

    if (args.found("outside"))
    {
        demTransfer transfer(mesh, dictionary());
        pointField all(anywhere(mesh.bounds(), 100, 0));
        all[37] = mesh.bounds().max() + 0.1*mesh.bounds().span();
        const int64_t first = int64_t(1) << 53;     // first + 37 is not a double
        grains g(all, 0.5e-3, first);
        const demParticleRouting::lostParticles s(transfer.locate(g.view, g.place.data()));
        const scalar away = returnReduce(mag(s.position - all[37]), maxOp<scalar>());
        claim
        (
            returnReduce(s.count == 1 && s.id == first + 37 && s.velocity == vector(37, 1, 0), andOp<bool>()) && away < 1e-12,
            "a particle outside the mesh is named on all ranks, its place differs by", away
        );
        testLimits();
        Info<< "End of claims" << endl;
        return 0;
    }

    pointField all(anywhere(mesh.bounds(), 2000, 0, is.corner));
    all.append(seams(mesh));

    if (args.found("boundary"))
    {
        testBoundary(mesh, args.globalPath()/"serialBoundary");
        Info<< "End of claims" << endl;
        return 0;
    }
    if (args.found("widths"))
    {
        testWidths(mesh);
        Info<< "End of claims" << endl;
        return 0;
    }
    if (args.found("wedge"))
    {
        testWedge(mesh);
        Info<< "End of claims" << endl;
        return 0;
    }
    if (args.found("rings"))
    {
        testRings(mesh, args.globalPath()/"serial");
        Info<< "End of claims" << endl;
        return 0;
    }
    if (args.found("own"))
    {
        testOwn(mesh, all);
        Info<< "End of claims" << endl;
        return 0;
    }
    if (args.found("hard"))
    {
        testHard(mesh);
        testLumps(mesh, args.globalPath()/"serial");
        Info<< "End of claims" << endl;
        return 0;
    }

    if (!args.found("same"))
    {
        testKernels(mesh, is, all);
    }
    testPlaces(mesh, is);
    testLargeIds(mesh, is);
    if (!is.periodic)
    {
        testBoundary(mesh, args.globalPath()/"serialBoundary");
    }
    testSerial(mesh, is, args.globalPath()/"serial");
    if (!Pstream::parRun())
    {
        if (!is.corner)
        {
            testWalk(mesh, is.planar);
            if (is.planar)
            {
                testBruteForce(mesh);
            }
            if (!is.periodic)
            {
                testBorders(mesh);
            }
        }
        timing(mesh, is);
    }

    Info<< "End of claims" << endl;
    return 0;
}


// ************************************************************************* //
