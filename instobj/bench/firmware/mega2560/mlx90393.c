/* MLX90393, Melexis 3901090393: commands and registers of chapters 13 to 15. */
#include <util/delay.h>

#include "bus.h"
#include "chips.h"
#include "plan.h"

enum { START_BURST = 0x1F, READ = 0x4F, WRITE_REGISTER = 0x60, EXIT = 0x80, RESET = 0xF0 };
enum { ERROR = 0x10 };
enum { HALL_CONFIGURATION = 0x0C, FILTER = 4, OVERSAMPLING = 2 };

static bool command(uint8_t address, uint8_t code)
{
    uint8_t status;
    return bus_transfer(address, &code, 1, &status, 1);
}

static bool set(uint8_t address, uint8_t reg, uint16_t value)
{
    uint8_t out[4] = {WRITE_REGISTER, (uint8_t)(value >> 8), (uint8_t)value, (uint8_t)(reg << 2)};
    uint8_t status;
    return bus_transfer(address, out, 4, &status, 1) && !(status & ERROR);
}

bool chip_move(uint8_t from, uint8_t to)
{
    return from == to;
}

bool chip_setup(uint8_t address)
{
    bool answers = command(address, EXIT);
    _delay_ms(1);
    answers = answers && command(address, RESET);
    _delay_ms(2);
    uint16_t resolution = (uint16_t)MLX_RESOLUTION << 9 | MLX_RESOLUTION << 7 | MLX_RESOLUTION << 5;
    return answers && set(address, 0, MLX_GAIN << 4 | HALL_CONFIGURATION) && set(address, 1, 0) &&
           set(address, 2, resolution | FILTER << 2 | OVERSAMPLING) && command(address, START_BURST);
}

/* Z has steps 1.613 times as wide as X and Y. */
static int16_t in_steps_of_x(int16_t z)
{
    int32_t scaled = (int32_t)z * 413 / 256;
    return scaled > INT16_MAX ? INT16_MAX : scaled < INT16_MIN ? INT16_MIN : (int16_t)scaled;
}

bool chip_read(uint8_t address, int16_t values[VALUES])
{
    uint8_t code = READ, in[2 * VALUES + 1];
    if (!bus_transfer(address, &code, 1, in, sizeof in) || in[0] & ERROR)
        return false;
    for (uint8_t k = 0; k < VALUES; k++)
        values[k] = (int16_t)((uint16_t)in[2 * k + 1] << 8 | in[2 * k + 2]);
    values[Z] = in_steps_of_x(values[Z]);
    return true;
}

bool chip_undervoltage(uint8_t address)
{
    (void)address; /* the chip does not say */
    return false;
}

int16_t chip_decidegrees(int16_t temperature)
{
    /* 45.2 counts a degree, 46244 at 35 degrees; rounded */
    return (int16_t)((3505 + ((int32_t)(uint16_t)temperature - 46244) * 1000 / 452) / 10);
}
