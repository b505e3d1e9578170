/*---------------------------------------------------------------------------*\
    demGaussianKernel.C -- integral of a truncated Gaussian over a cell, taken as a
    box.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demGaussianKernel.H"
#include "volFields.H"
#include "mathematicalConstants.H"

namespace Foam
{
    // Distance, in b', at which the Gaussian is truncated
    static const scalar cutoff = 2.5;

    // Variance of max(0, exp(-r^2) - exp(-cutoff^2)) in each direction, over 1/2:
    // with cutoff = 2.5 the integrals of r^4 and r^2 are .60799 and .43046
    static const scalar varianceRatio = 0.9416;

    // A box has integral 0 when its nearest point is farther than this, in b':
    // exp(-r^2) < exp(-cutoff^2)/pi^(3/2), with a margin for cells that are not boxes
    static const scalar support = 3;

    // Value of the Gaussian at the cut-off, in 1/b'^3
    static const scalar atCutoff = std::exp(-sqr(cutoff))/std::pow(constant::mathematical::pi, 1.5);

    defineTypeNameAndDebug(demGaussianKernel, 0);
    addToRunTimeSelectionTable(demKernel, demGaussianKernel, parts);
}


//- Jacobi's eigenvalue algorithm: s becomes diagonal, axes has the eigenvectors in rows
static void diagonalise(Foam::symmTensor& s, Foam::tensor& axes)
{
    using namespace Foam;
    tensor m(s);
    axes = tensor::I;

    // three sweeps of three rotations reach 1e-16; the fourth is a reserve
    for (label round = 0; round < 12; ++round)
    {
        const direction p = round % 3 == 2 ? 1 : 0;
        const direction q = round % 3 == 0 ? 1 : 2;
        const scalar off = m[3*p + q];
        const scalar difference = m[3*q + q] - m[3*p + p];
        if (mag(off) <= 1e-15*tr(m)) continue;

        const scalar angle = 0.5*std::atan2(2*off, difference);
        tensor r(tensor::I);
        r[3*p + p] = r[3*q + q] = std::cos(angle);
        r[3*p + q] = -std::sin(angle);
        r[3*q + p] = std::sin(angle);
        m = r & m & r.T();
        axes = r & axes;
    }
    s = symm(m);
}


void Foam::demGaussianKernel::measure(const label celli)
{
    const labelList& corners = mesh_.cellPoints()[celli];
    point mean(Zero);
    for (const label pointi : corners)
    {
        mean += mesh_.points()[pointi]/corners.size();
    }
    symmTensor spread(Zero);
    for (const label pointi : corners)
    {
        spread += sqr(mesh_.points()[pointi] - mean)/scalar(corners.size());
    }
    diagonalise(spread, axes_[celli]);

    // the corners of a box are one half width away from the centre in each direction
    vector h
    (
        std::sqrt(max(spread.xx(), scalar(0))),
        std::sqrt(max(spread.yy(), scalar(0))),
        std::sqrt(max(spread.zz(), scalar(0)))
    );
    const scalar box = 8*h.x()*h.y()*h.z();
    const scalar size = std::cbrt(mesh_.V()[celli]);
    half_[celli] = box > 0 ? h*(size/std::cbrt(box)) : vector::uniform(0.5*size);
}


Foam::demGaussianKernel::demGaussianKernel(const parts& p)
:
    demFootprintKernel(p),
    b_(0),
    axes_(mesh_.nCells()),
    half_(mesh_.nCells())
{
    if (p.coupling.getOrDefault<scalar>("width", 1) == 0)
    {
        FatalIOErrorInFunction(p.coupling)
            << "coupling/width 0 is no width for kernel gaussian; give its width in particle"
            << " diameters, 3 for example" << exit(FatalIOError);
    }
    forAll(half_, celli)
    {
        measure(celli);
    }
}


void Foam::demGaussianKernel::setWidth(const scalar, const scalar b)
{
    b_ = b/std::sqrt(varianceRatio);
}


Foam::scalar Foam::demGaussianKernel::reach(const scalar) const
{
    return support*b_;
}


Foam::scalar Foam::demGaussianKernel::integral
(
    const label celli,
    const point& x,
    const scalar
) const
{
    const vector d((axes_[celli] & (mesh_.cellCentres()[celli] - x))/b_);
    const vector h(half_[celli]/b_);

    scalar integral = 1;
    scalar offset = atCutoff;
    for (direction k = 0; k < 3; ++k)
    {
        integral *= 0.5*(std::erf(mag(d[k]) + h[k]) - std::erf(mag(d[k]) - h[k]));
        offset *= min(2*h[k], scalar(1));
    }
    return max(integral - offset, scalar(0));
}
