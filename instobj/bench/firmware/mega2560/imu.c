#include "imu.h"

#ifdef IMU_ADDRESS
#include <string.h>

#include "bus.h"
#include "line.h"

enum { CELLS = 6 };

static bool alive;
static uint8_t data[2 * CELLS];

static bool setup(void)
{
    static const uint8_t settings[][2] = IMU_SETUP;
    const uint8_t who = IMU_WHO;
    uint8_t name;
    if (!bus_transfer(IMU_ADDRESS, &who, 1, &name, 1) || name != IMU_NAME)
        return false;
    for (uint8_t k = 0; k < sizeof settings / sizeof *settings; k++)
        if (!bus_transfer(IMU_ADDRESS, settings[k], 2, 0, 0))
            return false;
    return true;
}

void imu_watch(void)
{
    if (!alive)
        alive = setup();
}

static int16_t count(uint8_t cell)
{
    uint8_t low = data[2 * cell + !IMU_LOW_FIRST], high = data[2 * cell + IMU_LOW_FIRST];
    return (int16_t)((uint16_t)high << 8 | low);
}

/* A part without its settings gives one number six times; gravity never does. */
void imu_read(void)
{
    const uint8_t first = IMU_DATA;
    alive = alive && bus_transfer(IMU_ADDRESS, &first, 1, data, sizeof data)
            && memcmp(data, data + 2, sizeof data - 2);
}

void imu_send(void)
{
    for (uint8_t cell = 0; cell < CELLS; cell++) {
        bool rate = cell >= CELLS / 2;
        uint8_t place = (uint8_t)(cell % 3 + (rate != IMU_RATE_FIRST ? 3 : 0));
        int64_t scaled = count(place) * (rate ? IMU_RATE : IMU_ACCELERATION);
        if (alive)
            line_fraction((int32_t)(scaled / 65536), rate ? 10000 : 1000);
        else
            line_empty();
    }
}
#endif
