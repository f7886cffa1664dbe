// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the OpenVDB files of the tests in Python: AirlightWriteOpenVDB FOLDER/

#include "AirlightTestOpenVDB.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FOLDER/\n";
    return EXIT_FAILURE;
  }
  airlight_test::WriteOpenVDBFiles(argv[1]);
  return EXIT_SUCCESS;
}
