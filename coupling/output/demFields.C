/*---------------------------------------------------------------------------*\
    demFields.C -- deposits particle quantities as fields of the mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demFields.H"
#include "demFiles.H"
#include "demCheck.H"
#include "demColumns.H"

namespace Foam
{

static scalar mass(const demView& view, const label i)
{
    return *dem_at(view.mass, view.stride, i);
}


// Deposit a symmetric tensor as two vectors: diagonal xx yy zz, rest xy yz zx
static tmp<symmTensorField> depositTensor
(
    const demTransfer& transfer,
    const vectorField& diagonal,
    const vectorField& offDiagonal
)
{
    vectorField a, b;
    transfer.deposit(diagonal, a);
    transfer.deposit(offDiagonal, b);

    tmp<symmTensorField> tresult(new symmTensorField(a.size()));
    symmTensorField& result = tresult.ref();
    forAll(result, c)
    {
        result[c] = symmTensor
        (
            a[c].x(), b[c].x(), b[c].z(), a[c].y(), b[c].y(), a[c].z()
        );
    }
    return tresult;
}


template<class GeoField>
static void set(GeoField& field, const Field<typename GeoField::value_type>& values)
{
    field.primitiveFieldRef() = values;
    field.correctBoundaryConditions();
}

} // End namespace Foam


template<class Type>
void Foam::demFields::make
(
    autoPtr<GeometricField<Type, fvPatchField, volMesh>>& field,
    const wordList& wanted,
    const word& name,
    const dimensionSet& dimensions
)
{
    if (!wanted.found(name))
    {
        return;
    }

    field.reset
    (
        new GeometricField<Type, fvPatchField, volMesh>
        (
            demFieldAt
            (
                mesh_,
                IOobject::groupName(name, "particles"),
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            mesh_,
            dimensioned<Type>(dimensions, Zero)
        )
    );
}


Foam::tmp<Foam::symmTensorField> Foam::demFields::flux
(
    const demTransfer& transfer,
    const demView& view
) const
{
    vectorField diagonal(view.n), offDiagonal(view.n);

    forAll(diagonal, i)
    {
        const vector v(velocity(view, i));
        diagonal[i] = mass(view, i)*cmptMultiply(v, v);
        offDiagonal[i] =
            mass(view, i)*vector(v.x()*v.y(), v.y()*v.z(), v.z()*v.x());
    }
    return depositTensor(transfer, diagonal, offDiagonal);
}


Foam::demFields::demFields(const fvMesh& mesh, const dictionary& coupling)
:
    mesh_(mesh)
{
    const wordList known({"alpha", "U", "Theta", "stress"});
    const wordList wanted(coupling.getOrDefault<wordList>("fields", wordList()));

    for (const word& name : wanted)
    {
        if (!known.found(name))
        {
            FatalIOErrorInFunction(coupling)
                << "fields: there is no particle field " << name << ";"
                << " known: " << flatOutput(known) << exit(FatalIOError);
        }
    }

    make(alpha_, wanted, "alpha", dimless);
    make(U_, wanted, "U", dimVelocity);
    make(Theta_, wanted, "Theta", sqr(dimVelocity));
    make(stress_, wanted, "stress", dimPressure);
}


void Foam::demFields::prepare(::dem_case* c) const
{
    if (stress_)
    {
        demCheck(dem_case_enable_virial(c));
    }
}


void Foam::demFields::note(const string& heading)
{
    if (alpha_)
    {
        alpha_().note() = heading;
    }
    if (U_)
    {
        U_().note() = heading;
    }
    if (Theta_)
    {
        Theta_().note() = heading;
    }
    if (stress_)
    {
        stress_().note() = heading;
    }
}


void Foam::demFields::update
(
    ::dem* d,
    const demTransfer& transfer,
    const demView& view
)
{
    if (alpha_)
    {
        scalarField solid;
        transfer.deposit(volumes(view), solid);
        set(alpha_(), solid);
    }

    if (!U_ && !Theta_ && !stress_)
    {
        return;
    }

    scalarField m(view.n);
    vectorField momentum(view.n);
    forAll(m, i)
    {
        m[i] = mass(view, i);
        momentum[i] = m[i]*velocity(view, i);
    }

    scalarField rho;            // mass of particles per volume [kg/m3]
    vectorField meanV;
    transfer.deposit(m, rho);
    transfer.deposit(momentum, meanV);
    meanV /= max(rho, VSMALL);

    if (U_)
    {
        set(U_(), meanV);
    }

    if (!Theta_ && !stress_)
    {
        return;
    }

    // Relative to the mean velocity of the cell
    const symmTensorField motion(flux(transfer, view) - rho*sqr(meanV));

    if (Theta_)
    {
        set(Theta_(), tr(motion)/(3*max(rho, VSMALL)));
    }

    if (stress_)
    {
        scalarField virial(6*view.n);
        demCheck(dem_virial(d, virial.begin()));

        vectorField diagonal(view.n), offDiagonal(view.n);
        forAll(diagonal, i)
        {
            diagonal[i] = vectorAt(virial.cdata(), 2*i);
            offDiagonal[i] = vectorAt(virial.cdata(), 2*i + 1);
        }
        set(stress_(), depositTensor(transfer, diagonal, offDiagonal) - motion);
    }
}
