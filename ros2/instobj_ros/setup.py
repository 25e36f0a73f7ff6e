from setuptools import setup

setup(
    name="instobj_ros",
    version="0.2.0",
    packages=["instobj_ros"],
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/instobj_ros"]),
        ("share/instobj_ros", ["package.xml"]),
        ("share/instobj_ros/launch", ["launch/contacts.launch.py"]),
    ],
    install_requires=["setuptools", "instobj-robot"],
    entry_points={"console_scripts": ["contacts = instobj_ros.contacts:main"]},
)
