/*
 * boxKernel.C -- a kernel of one's own in a library: a top-hat filter, uniform in a cube with sides
 * of b, for cells that are boxes along the axes (docs/kernels.md).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later
 */
#include "demFootprintKernel.H"

namespace Foam
{

class boxKernel
:
    public demFootprintKernel
{
    scalar b_ = 0;      // [m]

public:

    TypeName("box");

    boxKernel(const parts& p) : demFootprintKernel(p) {}

    // coupling/width and coupling/diameter are settings of it
    bool uses(const word& entry) const { return entry == "width" || entry == "diameter"; }

    void setWidth(const scalar diameter, const scalar b) { b_ = b; }

    // cells farther from the particle than this have no part of it [m]
    scalar reach(const scalar radius) const { return std::sqrt(3.0)/2*b_; }

    // part of the cell, in any unit: all parts are divided by their sum
    scalar integral(const label celli, const point& x, const scalar radius) const
    {
        const boundBox cell(mesh_.cells()[celli].points(mesh_.faces(), mesh_.points()), false);
        scalar volume = 1;
        for (direction k = 0; k < 3; ++k)
        {
            const scalar low = max(cell.min()[k], x[k] - b_/2);
            const scalar high = min(cell.max()[k], x[k] + b_/2);
            volume *= max(high - low, scalar(0));
        }
        return volume;
    }
};

defineTypeNameAndDebug(boxKernel, 0);
addToRunTimeSelectionTable(demKernel, boxKernel, parts);

}
