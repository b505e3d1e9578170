/*---------------------------------------------------------------------------*\
    demFluid.C -- looks up the fluid's fields and properties in any solver.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFluid.H"
#include "demFiles.H"
#include "demDict.H"
#include "fvOptionList.H"
#include "uniformDimensionedFields.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "HashSet.H"
#include "turbulenceModel.H"

namespace Foam
{

static tmp<volScalarField> uniform
(
    const fvMesh& mesh,
    const dimensionedScalar& value
)
{
    return tmp<volScalarField>
    (
        new volScalarField
        (
            demFileAt(mesh.time().timeName(), "dem:" + value.name(), mesh, IOobject::NO_READ),
            mesh,
            value
        )
    );
}

} // End namespace Foam


Foam::demFluid::demFluid(const fvMesh& mesh, const demDict& dict)
:
    mesh_(mesh),
    dict_(dict)
{
    // Refuse missing fields now, not in the first step
    velocity();
    pressureGradient();
    checkViscosity(viscosity()());

    if (!mesh.foundObject<volScalarField>("p"))
    {
        Info<< "Suna: the solver has no field p; particles feel the hydrostatic"
            << " pressure gradient only" << endl;
    }
}


bool Foam::demFluid::hasUniformDensity
(
    const fvMesh& mesh,
    const dictionary& own
)
{
    const dictionary* transport =
        mesh.findObject<dictionary>("transportProperties");

    return own.found("rho") || (transport && transport->found("rho"));
}


Foam::scalar Foam::demFluid::uniformDensity
(
    const fvMesh& mesh,
    const dictionary& own
)
{
    const dictionary* transport =
        mesh.findObject<dictionary>("transportProperties");

    const bool inCoupling = own.found("rho");
    const bool inTransport = transport && transport->found("rho");

    if (!inCoupling && !inTransport)
    {
        FatalIOErrorInFunction(own)
            << "The density of the fluid is missing: add rho <kg/m3> to"
            << " coupling in constant/" << demDict::name()
            << exit(FatalIOError);
    }

    const scalar rho =
        dimensionedScalar("rho", dimDensity, inCoupling ? own : *transport).value();

    if (inCoupling && inTransport)
    {
        const scalar other =
            dimensionedScalar("rho", dimDensity, *transport).value();

        if (mag(rho - other) > 1e-9*mag(rho))
        {
            FatalIOErrorInFunction(own)
                << "The density of the fluid is " << rho << " kg/m3 here and "
                << other << " kg/m3 in constant/transportProperties; write it"
                << " in one place only" << exit(FatalIOError);
        }
    }

    if (rho <= 0)
    {
        FatalIOErrorInFunction(own)
            << "The density of the fluid is " << rho << " kg/m3; it must be"
            << " positive" << exit(FatalIOError);
    }

    return rho;
}


bool Foam::demFluid::hasPhases(const fvMesh& mesh)
{
    const dictionary* transport = mesh.findObject<dictionary>("transportProperties");

    return transport && transport->found("phases");
}


Foam::scalar Foam::demFluid::largestDensity
(
    const fvMesh& mesh,
    const dictionary& own
)
{
    if (!hasPhases(mesh))
    {
        return uniformDensity(mesh, own);
    }

    const dictionary& transport = mesh.lookupObject<dictionary>("transportProperties");
    scalar largest = 0;
    for (const word& phase : wordList(transport.lookup("phases")))
    {
        largest = max
        (
            largest,
            dimensionedScalar("rho", dimDensity, transport.subDict(phase)).value()
        );
    }
    return largest;
}


const Foam::volVectorField& Foam::demFluid::velocity() const
{
    return lookup<volVectorField>(mesh_, "U");
}


Foam::word Foam::demFluid::timeScheme(const fvMesh& mesh)
{
    const dictionary schemes(mesh.schemesDict().subOrEmptyDict("ddtSchemes"));

    for (const char* term : {"ddt(U)", "ddt(rho,U)", "default"})
    {
        if (schemes.found(term))
        {
            return word(schemes.lookup(term));
        }
    }
    return word::null;
}


bool Foam::demFluid::steady(const fvMesh& mesh)
{
    const wordHashSet steadySchemes
    ({
        "steadyState", "localEuler", "SLTS", "CoEuler"
    });
    return steadySchemes.found(timeScheme(mesh));
}


Foam::scalar Foam::demFluid::interval(const fvMesh& mesh, const dictionary& own)
{
    const bool isSteady = steady(mesh);
    const scalar length = own.getOrDefault<scalar>("interval", 0);

    if (isSteady && !own.found("interval"))
    {
        FatalIOErrorInFunction(own)
            << "This solver is steady (ddtSchemes): its iterations have no"
            << " time step, but particles move in time. Add interval <s> to"
            << " coupling in constant/" << demDict::name() << ", the time that"
            << " particles move in each iteration, or take a transient solver"
            << exit(FatalIOError);
    }

    for (const char* name : {"interval", "relaxation"})
    {
        if (!isSteady && own.found(name))
        {
            FatalIOErrorInFunction(own)
                << name << " is for steady solvers; here particles move by the"
                << " solver's time step. Take it out of coupling in constant/"
                << demDict::name() << exit(FatalIOError);
        }
    }

    if (isSteady && length <= 0)
    {
        FatalIOErrorInFunction(own)
            << "interval is " << length << " s; it must be positive"
            << exit(FatalIOError);
    }
    return length;
}


Foam::tmp<Foam::volScalarField> Foam::demFluid::density() const
{
    const volScalarField* rho = mesh_.findObject<volScalarField>("rho");

    if (rho && rho->dimensions() == dimDensity)
    {
        dict_.refuseDuplicate("rho", "the solver");
        return tmp<volScalarField>(*rho);
    }
    return uniform
    (
        mesh_,
        dimensionedScalar("rho", dimDensity, uniformDensity(mesh_, dict_.coupling()))
    );
}


Foam::vector Foam::demFluid::alongPeriods(const fvMesh& mesh, const vector& g)
{
    DynamicList<vector> periods;
    vector along(Zero);

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch) || isA<processorCyclicPolyPatch>(patch))
        {
            periods.append(refCast<const coupledPolyPatch>(patch).separation());
        }
    }
    // The longest one that is left gives the next axis, the same on all ranks
    for (label axis = 0; axis < 3; ++axis)
    {
        vector longest(Zero);
        for (const vector& period : periods)
        {
            longest = maxMagSqrOp<vector>()(longest, period);
        }
        reduce(longest, maxMagSqrOp<vector>());
        if (mag(longest) < 1e-6*mesh.bounds().mag())
        {
            break;
        }
        longest /= mag(longest);
        along += (g & longest)*longest;
        for (vector& period : periods)
        {
            period -= (period & longest)*longest;
        }
    }
    return mag(along) > 1e-9*mag(g) ? along : vector(Zero);
}


void Foam::demFluid::checkGravity(const fvMesh& mesh, const vector& g)
{
    const vector along(alongPeriods(mesh, g));
    const volScalarField* rho = mesh.findObject<volScalarField>("rho");
    const bool varies =
        rho && gMax(rho->primitiveField()) > (1 + 1e-9)*gMin(rho->primitiveField());

    if (varies && mesh.foundObject<volScalarField>("p_rgh") && mag(along) > 0)
    {
        FatalErrorInFunction
            << "constant/g has the part " << along << " m/s2 along cyclic patches, but p_rgh"
            << " of this solver has no weight along them, and it would lose fluid where the"
            << " density changes; use demInterFoam or demPimpleFoam, or walls instead of"
            << " cyclic patches" << exit(FatalError);
    }
}


void Foam::demFluid::checkSources(const fv::optionList& sources)
{
    for (const fv::option& source : sources)
    {
        if (source.type() == "buoyancyForce")
        {
            FatalErrorInFunction
                << "fvOptions has " << source.name() << " of type buoyancyForce, but the particles"
                << " get the weight of the fluid that they displace from constant/g: gravity would"
                << " act twice; take it out" << exit(FatalError);
        }
        if (source.type() == "tabulatedAccelerationSource")
        {
            FatalErrorInFunction
                << "fvOptions has " << source.name() << " of type tabulatedAccelerationSource, an"
                << " acceleration that the particles would not feel: move the mesh instead"
                << " (constant/dynamicMeshDict)" << exit(FatalError);
        }
    }
}


void Foam::demFluid::checkViscosity(const volScalarField& mu)
{
    const scalar least = gMin(mu.primitiveField());

    if (!(least > 0))
    {
        FatalErrorInFunction
            << "The viscosity of the fluid is " << least << " Pa s; it must be positive: correct"
            << " nu or mu in constant/transportProperties, thermophysicalProperties or coupling of "
            << demDict::name() << exit(FatalError);
    }
}


Foam::tmp<Foam::volScalarField> Foam::demFluid::viscosity() const
{
    const turbulenceModel* model =
        mesh_.findObject<turbulenceModel>(turbulenceModel::propertiesName);

    if (model)
    {
        dict_.refuseDuplicate("nu", "the solver");
        return density()*model->nu();
    }

    const dictionary* transport =
        mesh_.findObject<dictionary>("transportProperties");
    const dictionary& own = dict_.coupling();

    if (transport && transport->found("nu"))
    {
        dict_.refuseDuplicate("nu", "constant/transportProperties");
        return
            density()*dimensionedScalar("nu", dimViscosity, *transport);
    }
    if (!own.found("nu"))
    {
        FatalIOErrorInFunction(own)
            << "The viscosity of the fluid is missing: add nu <m2/s> to"
            << " coupling in constant/" << demDict::name()
            << exit(FatalIOError);
    }

    return density()*dimensionedScalar("nu", dimViscosity, own);
}
