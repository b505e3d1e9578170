/*---------------------------------------------------------------------------*\
    demCapillaryForce.C -- surface tension on particles at the interface of two fluids.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCapillaryForce.H"
#include "cellVector.H"
#include "demColumns.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "fvcSnGrad.H"
#include "halfCellMean.H"
#include "surfaceTensionModel.H"

Foam::demCapillaryForce::demCapillaryForce(const demParticles& particles)
:
    particles_(particles),
    view_(particles.view()),
    fluid_(particles.fluid()),
    transfer_(particles.transfer()),
    tension_
    (
        particles.mesh().findObject<surfaceTensionModel>(surfaceTensionModel::typeName)
    ),
    alpha_(nullptr),
    warned_(false),
    onFaces_
    (
        IOobject
        (
            "dem:capillaryForce",
            particles.mesh().time().timeName(),
            particles.mesh(),
            IOobject::NO_READ
        ),
        particles.mesh(),
        dimensionedScalar(dimPressure*dimLength, Zero)
    ),
    onParticles_(Zero),
    onFrozen_(Zero)
{
    const word effect(particles.dict().effectWith(DEM_TRAIT_INTERFACE));

    if (!tension_ || (particles.twoWay() && !particles.displaceFluid()))
    {
        FatalErrorInFunction
            << "The effect " << effect << " acts at the interface of two fluids, which gets the"
            << " opposite force; only demInterFoam has it in its equations: take the effect out,"
            << " or use demInterFoam" << exit(FatalError);
    }
    if (!(gMax(tension_->sigma()().primitiveField()) > 0))
    {
        FatalErrorInFunction
            << "The effect " << effect << " is the force of surface tension, but sigma of"
            << " constant/transportProperties is 0: give the surface tension between the fluids"
            << " [N/m], or take the effect out" << exit(FatalError);
    }

    const dictionary& transport =
        particles.mesh().lookupObject<dictionary>("transportProperties");
    alpha_ = &particles.mesh().lookupObject<volScalarField>
    (
        IOobject::groupName("alpha", wordList(transport.lookup("phases"))[0])
    );
    onFaces_.setOriented();
}


void Foam::demCapillaryForce::warnOfStep()
{
    const scalar longest = 2*M_SQRT2*longestStep();

    if (!warned_ && particles_.window() > longest)
    {
        warned_ = true;
        WarningInFunction
            << "particles at the interface may jump off it: the step, " << particles_.window()
            << " s, is longer than " << longest << " s, sqrt(m/(pi sigma)) of the lightest"
            << " particle; use a smaller deltaT, or adjustTimeStep yes, which limits it" << endl;
    }
}


void Foam::demCapillaryForce::toParticles()
{
    warnOfStep();

    const fvMesh& mesh = particles_.mesh();
    const surfaceScalarField alphaGradient(fvc::snGrad(*alpha_)*mesh.magSf());
    const vectorField gradient(cellVector::gather<scalar, vector>(alphaGradient)/mesh.V().field());
    const vectorField G(transfer_.sample<vector>(gradient));
    const scalarField alpha(transfer_.sample(*alpha_));
    const scalarField sigma(transfer_.sample(tension_->sigma()()));

    forAll(G, i)
    {
        const scalar size = max(mag(G[i]), VSMALL);
        const vector n(-G[i]/size);
        const double* v = dem_at(view_.velocity, view_.stride, size_t(i));
        const scalar rise = (vector(v[0], v[1], v[2]) - vectorAt(fluid_.velocity, i)) & n;
        const scalar z = (0.5 - alpha[i])/size + particles_.window()*rise;
        const bool reached = mag(z) < *dem_at(view_.radius, view_.stride, size_t(i));
        const vector tension(reached ? vector(sigma[i]*n) : vector::zero);

        fluid_.interface_distance[i] = reached ? z : 0;
        for (direction d = 0; d < 3; d++)
        {
            fluid_.tension[3*i + d] = tension[d];
        }
    }

    vectorField force(view_.n);
    dem_fluid_interface_force(particles_.core(), reinterpret_cast<scalar*>(force.begin()));
    onParticles_ = onFrozen_ = Zero;
    forAll(force, i)
    {
        onParticles_ += force[i];
        if (isFrozen(view_, i))
        {
            onFrozen_ += force[i];
        }
    }
    if (!particles_.react())
    {
        return;
    }

    scalarField pull(view_.n);
    forAll(pull, i)
    {
        pull[i] = -(force[i] & G[i])/max(magSqr(G[i]), VSMALL);
    }
    volScalarField lambda
    (
        IOobject("lambda", mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE),
        mesh,
        dimensionedScalar(dimPressure, Zero),
        extrapolatedCalculatedFvPatchScalarField::typeName
    );
    transfer_.deposit(pull, lambda.ref());
    lambda.correctBoundaryConditions();
    onFaces_ = halfCellMean(lambda)*alphaGradient;
}


Foam::scalar Foam::demCapillaryForce::longestStep() const
{
    scalar lightest = GREAT;

    for (size_t i = 0; i < view_.n; i++)
    {
        if (!isFrozen(view_, i))
        {
            lightest = min(lightest, *dem_at(view_.mass, view_.stride, i));
        }
    }
    reduce(lightest, minOp<scalar>());
    return
        0.5*sqrt
        (
            lightest
           /(constant::mathematical::twoPi*gMax(tension_->sigma()().primitiveField()))
        );
}
