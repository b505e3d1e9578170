/*---------------------------------------------------------------------------*\
    demTransfer.C -- locate, sample, deposit.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demTransfer.H"
#include "demCheck.H"


void Foam::demTransfer::read(const dictionary& coupling)
{
    const wordList kernels({"diffusion", "linear", "particleCentre"});
    const wordList bases({"linear", "particleCentre"});
    const word kernel(coupling.getOrDefault<word>("kernel", "diffusion"));
    const word base(coupling.getOrDefault<word>("base", "linear"));
    const bool diffusion = kernel == "diffusion";

    width_ = coupling.getOrDefault<scalar>("width", 3);
    minVoidFraction_ = coupling.getOrDefault<scalar>("minVoidFraction", 0.2);

    if (!kernels.found(kernel))
    {
        demUnknown(coupling, "coupling", "kernel", kernel, kernels);
    }
    if (!bases.found(base))
    {
        demUnknown(coupling, "coupling", "base", base, bases);
    }
    for (const char* name : {"width", "base", "diameter"})
    {
        if (!diffusion && coupling.found(name))
        {
            FatalIOErrorInFunction(coupling)
                << "coupling/" << name << " is of the smoothing, but kernel "
                << kernel << " does not smooth; take it out, or use kernel"
                << " diffusion" << exit(FatalIOError);
        }
    }
    if (width_ < 0)
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/width " << width_ << " is negative; give the smoothing"
            << " length in particle diameters, 0 for none" << exit(FatalIOError);
    }
    if (coupling.getOrDefault<scalar>("diameter", 1) <= 0)
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/diameter is " << coupling.get<scalar>("diameter")
            << " m; it must be positive" << exit(FatalIOError);
    }
    if (minVoidFraction_ < 0 || minVoidFraction_ > 1)
    {
        FatalIOErrorInFunction(coupling)
            << "coupling/minVoidFraction " << minVoidFraction_ << " is out of"
            << " range; give a number from 0 to 1" << exit(FatalIOError);
    }

    linear_ = diffusion ? base == "linear" : kernel == "linear";
    width_ = diffusion ? width_ : 0;
}


void Foam::demTransfer::build()
{
    route_.clear();
    locator_.reset(new demLocator(mesh_));
    route_.reset(new demRoute(mesh_, locator_()));
    weights_.reset(new demWeights(mesh_));
    smoother_.reset(new demSmoother(mesh_));
    smoother_().setWidth(width_*diameter_);
}


Foam::demTransfer::demTransfer(const fvMesh& mesh, const dictionary& coupling)
:
    mesh_(mesh),
    width_(0),
    minVoidFraction_(0),
    linear_(true),
    diameter_(0)
{
    read(coupling);
    build();
}


void Foam::demTransfer::setDiameter(const scalar d)
{
    const scalar most = mesh_.bounds().mag();

    if (width_*d > most)
    {
        FatalErrorInFunction
            << "coupling/width is " << width_ << " diameters of " << d
            << " m, together more than the mesh is long (" << most
            << " m); give a smaller width or diameter" << exit(FatalError);
    }
    if (d != diameter_)
    {
        diameter_ = d;
        smoother_().setWidth(width_*d);
    }
}


Foam::demRoute::stray Foam::demTransfer::locate(const demView& view, double* place)
{
    if (mesh_.changing())
    {
        build();
    }
    const demRoute::stray outside(route_().locate(view, place));
    if (!linear_ && !outside.count)
    {
        route_().toCentres();
    }
    return outside;
}


template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::demTransfer::sample(const UList<Type>& cells) const
{
    Field<Type> smooth(cells);
    smoother_().smooth(smooth);

    tmp<Field<Type>> tvalues(new Field<Type>(route_().spots().size()));
    weights_().collect(route_().spots(), smooth, tvalues.ref());
    route_().toParticles(tvalues.ref());
    return tvalues;
}


template<class Type>
void Foam::demTransfer::deposit
(
    const UList<Type>& perParticle,
    Field<Type>& density
) const
{
    List<Type> values(perParticle);
    route_().toSpots(values);

    density.setSize(mesh_.nCells());
    density = Zero;
    weights_().spread(route_().spots(), values, density);
    density /= mesh_.V().field();
    smoother_().smooth(density);
}


#define INSTANTIATE(Type, VolField)                                            \
                                                                               \
template Foam::tmp<Foam::Field<Foam::Type>>                                    \
Foam::demTransfer::sample(const UList<Type>&) const;                           \
                                                                               \
template void Foam::demTransfer::deposit                                       \
(const UList<Type>&, Field<Type>&) const;                                      \
                                                                               \
Foam::tmp<Foam::Field<Foam::Type>>                                             \
Foam::demTransfer::sample(const VolField& field) const                         \
{                                                                              \
    return sample<Type>(field.primitiveField());                               \
}                                                                              \
                                                                               \
void Foam::demTransfer::deposit                                                \
(const UList<Type>& perParticle, VolField& density) const                      \
{                                                                              \
    deposit<Type>(perParticle, density.primitiveFieldRef());                   \
    density.correctBoundaryConditions();                                       \
}                                                                              \
                                                                               \
void Foam::demTransfer::deposit                                                \
(const UList<Type>& perParticle, VolField::Internal& density) const            \
{                                                                              \
    deposit<Type>(perParticle, density.field());                               \
}

INSTANTIATE(scalar, volScalarField)
INSTANTIATE(vector, volVectorField)

#undef INSTANTIATE


Foam::label Foam::demTransfer::crowded(const UList<scalar>& voidFraction) const
{
    label count = 0;
    for (const scalar e : voidFraction)
    {
        count += e < minVoidFraction_;
    }
    return returnReduce(count, sumOp<label>());
}


// ************************************************************************* //
