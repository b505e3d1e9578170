/*---------------------------------------------------------------------------*\
    demFluid.C -- looks up the fluid's fields and properties in any solver.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFluid.H"
#include "demFiles.H"
#include "demDict.H"
#include "demDrivingForce.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "fvcSurfaceIntegrate.H"
#include "surfaceInterpolate.H"
#include "surfaceFields.H"
#include "uniformDimensionedFields.H"
#include "HashSet.H"
#include "surfaceTensionModel.H"
#include "turbulenceModel.H"

namespace Foam
{

template<class Type>
static const Type& lookup(const fvMesh& mesh, const word& name)
{
    const Type* field = mesh.findObject<Type>(name);

    if (!field)
    {
        FatalErrorInFunction
            << "The solver has no " << Type::typeName << ' ' << name
            << ", which the particles need. Fields of this type: "
            << flatOutput(mesh.sortedNames<Type>()) << exit(FatalError);
    }
    return *field;
}


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


// Particles do not feel the jump of the pressure across a curved interface: fluid and
// particles together would gain momentum from a drop at rest. Null without an interface. The
// solver's interfaceProperties registers the curvature and the model of surface tension.
Foam::tmp<Foam::surfaceScalarField> Foam::demFluid::capillaryGradient() const
{
    const volScalarField* curvature =
        mesh_.findObject<volScalarField>("interfaceProperties:K");
    const surfaceTensionModel* tension =
        mesh_.findObject<surfaceTensionModel>(surfaceTensionModel::typeName);

    for (const char* name : {"transportProperties", "thermophysicalProperties"})
    {
        const dictionary* properties = mesh_.findObject<dictionary>(name);

        if (curvature && tension && properties && properties->found("phases"))
        {
            const word phase(wordList(properties->lookup("phases"))[0]);
            const volScalarField& alpha =
                lookup<volScalarField>(mesh_, IOobject::groupName("alpha", phase));

            return fvc::interpolate(tension->sigma()*(*curvature))*fvc::snGrad(alpha);
        }
    }
    return nullptr;
}


// p = p_rgh + rho gh, so grad p - rho g = grad p_rgh + gh grad rho. On faces, as
// the solver balances it, this is zero in a fluid at rest, less the force of surface
// tension. The gradient of p in cells is not, where the density jumps.
Foam::tmp<Foam::volVectorField> Foam::demFluid::dynamicGradient
(
    const volScalarField& p_rgh
) const
{
    const volScalarField& rho = lookup<volScalarField>(mesh_, "rho");
    const surfaceScalarField& ghf = lookup<surfaceScalarField>(mesh_, "ghf");

    surfaceScalarField gradient(fvc::snGrad(p_rgh) + ghf*fvc::snGrad(rho));
    const tmp<surfaceScalarField> tcapillary(capillaryGradient());
    if (tcapillary.valid())
    {
        gradient -= tcapillary();
    }

    // As fvc::reconstruct, but with names for both factors: it multiplies a tensor by a
    // temporary vector, and a compiler may overwrite a component before it reads it
    const volTensorField inverse(inv(fvc::surfaceSum(mesh_.Sf()*mesh_.Sf()/mesh_.magSf())));
    const volVectorField sum(fvc::surfaceSum(mesh_.Sf()*gradient));
    tmp<volVectorField> tresult
    (
        new volVectorField
        (
            IOobject("dynamicGradient", mesh_.time().timeName(), mesh_),
            mesh_,
            gradient.dimensions(),
            extrapolatedCalculatedFvPatchVectorField::typeName
        )
    );
    tresult.ref().primitiveFieldRef() = inverse.primitiveField() & sum.primitiveField();
    tresult.ref().correctBoundaryConditions();
    return tresult;
}


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


Foam::scalar Foam::demFluid::largestDensity
(
    const fvMesh& mesh,
    const dictionary& own
)
{
    const dictionary* transport =
        mesh.findObject<dictionary>("transportProperties");

    if (!transport || !transport->found("phases"))
    {
        return uniformDensity(mesh, own);
    }

    scalar largest = 0;
    for (const word& phase : wordList(transport->lookup("phases")))
    {
        largest = max
        (
            largest,
            dimensionedScalar("rho", dimDensity, transport->subDict(phase)).value()
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


Foam::tmp<Foam::volVectorField> Foam::demFluid::pressureGradient() const
{
    const dimensionedVector g("g", dimAcceleration, dict_.gravity());
    const volScalarField* p = mesh_.findObject<volScalarField>("p");
    const volScalarField* p_rgh = mesh_.findObject<volScalarField>("p_rgh");
    const tmp<volScalarField> trho(density());

    if (demDrivingForce::active(mesh_))
    {
        const volVectorField& U = velocity();
        const bool withDensity = p && p->dimensions() == dimPressure;
        const tmp<volVectorField> tdriving
        (
            withDensity
          ? demDrivingForce::source(U, dimForce/dimVolume)
          : trho()*demDrivingForce::source(U, dimAcceleration)
        );
        return solverGradient(p, p_rgh, trho(), g) - tdriving;
    }
    return solverGradient(p, p_rgh, trho(), g);
}


// Full pressure gradient from the pressure field of the solver
Foam::tmp<Foam::volVectorField> Foam::demFluid::solverGradient
(
    const volScalarField* p,
    const volScalarField* p_rgh,
    const volScalarField& rho,
    const dimensionedVector& g
) const
{
    if (p_rgh && p_rgh->dimensions() == dimPressure)
    {
        return dynamicGradient(*p_rgh) + rho*g;
    }
    if (!p)
    {
        return rho*g;
    }
    if (p_rgh)                  // over density: the Boussinesq solvers
    {
        return rho*fvc::grad(*p);
    }
    if (p->dimensions() == dimPressure)
    {
        return fvc::grad(*p) + rho*g;
    }
    return rho*(fvc::grad(*p) + g);
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
