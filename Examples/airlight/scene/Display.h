// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Display_h
#define Display_h

namespace airlight
{

/**
 * Throws UserError if windows need an X server and there is none. VTK 9.1 would end the program in
 * the middle of its first frame.
 */
void CheckDisplay();

}

#endif
